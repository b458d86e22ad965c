// Lines every 10 cm, 1 m and 10 m, one pixel wide at any distance; each set fades out where its lines would get too dense.
// Of all whole numbers, where `pixels` are from one to the next.
float lines(vec2 p, vec2 pixels, vec2 fade, float widthPx) {
    vec2 l = clamp(widthPx * 0.5 + 0.5 - abs(p - roundEven(p)) * pixels, 0.0, 1.0) * clamp(fade, 0.0, 1.0);
    return max(l.x, l.y);
}
// At a place where a pixel is `w` wide and a metre so many `pixels`.
float gridInk(vec2 p, vec2 w, vec2 pixels) {
    float fine = lines(p * 10.0, pixels * 0.1, 1.25 - 60.0 * w, 1.0);
    float metre = lines(p, pixels, 1.25 - 6.0 * w, 1.25);
    float ten = lines(p * 0.1, pixels * 10.0, 1.25 - 0.6 * w, 2.0);
    return max(max(fine * 0.13, metre * 0.34), ten * 0.52);
}
