#include "editor/radios/packet_text.h"

#include <QCoreApplication>

#include "editor/widgets/theme.h"
#include "radio/ieee802154.h"

namespace trundle {
namespace {

constexpr std::size_t kBeforePayload = 9, kAfterPayload = kFrameOverhead - kBeforePayload, kBytesInLine = 16;

QString tr(const char* text) { return QCoreApplication::translate("PacketText", text); }

} // namespace

QColor inkForMargin(double margin) { return ink(margin < 3 ? Ink::Error : margin < 10 ? Ink::Warning : Ink::Good); }

QString decibelText(double value) { return QString::number(value, 'f', 1); }

QString outcomeText(ReceptionOutcome outcome) {
    return QString::fromUtf8(outcomeName(outcome).data(), qsizetype(outcomeName(outcome).size()));
}

QString reasonOf(const FrameRecord& frame, const RadioDefinition& receiver, const QString& addressee) {
    switch (frame.outcome) {
    case ReceptionOutcome::Delivered: return {};
    case ReceptionOutcome::NotAddressed: return tr("it is for %1").arg(addressee);
    case ReceptionOutcome::TooWeak:
        return tr("%1 dBm is %2 dB below its MinReceivePower")
            .arg(decibelText(frame.link.power), decibelText(receiver.minReceivePower - frame.link.power));
    case ReceptionOutcome::Sending: return tr("it was sending itself, or about to");
    case ReceptionOutcome::Busy: return tr("it was receiving another frame");
    case ReceptionOutcome::Collision: return tr("another frame was too strong: SINR %1 dB").arg(decibelText(frame.sinr));
    case ReceptionOutcome::BitErrors: return tr("noise: SINR %1 dB").arg(decibelText(frame.sinr));
    case ReceptionOutcome::BufferFull: return tr("%1 packets waited unread, its BufferLimit").arg(receiver.bufferLimit);
    case ReceptionOutcome::Duplicate: return tr("a duplicate: its acknowledgement was lost");
    }
    return {};
}

std::span<const std::uint8_t> payloadOf(const AirFrame& frame, bool ack) {
    if (ack || frame.bytes.size() < kFrameOverhead) return {};
    return std::span(frame.bytes).subspan(kBeforePayload, frame.bytes.size() - kBeforePayload - kAfterPayload);
}

QString hexOf(std::span<const std::uint8_t> bytes) {
    return QString::fromLatin1(QByteArray(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size())).toHex());
}

QString asciiOf(std::span<const std::uint8_t> bytes) {
    QString text;
    for (const std::uint8_t byte : bytes) text += byte >= 0x20 && byte < 0x7f ? QChar(char16_t(byte)) : QChar(u'.');
    return text;
}

QString dumpOf(std::span<const std::uint8_t> bytes) {
    QString text;
    for (std::size_t at = 0; at < bytes.size(); at += kBytesInLine) {
        const auto line = bytes.subspan(at, std::min(kBytesInLine, bytes.size() - at));
        QString hex = hexOf(line);
        for (qsizetype i = hex.size() - 2; i > 0; i -= 2) hex.insert(i, u' ');
        if (!text.isEmpty()) text += u'\n';
        text += QStringLiteral("%1  %2  %3")
                    .arg(qulonglong(at), 4, 16, QLatin1Char('0'))
                    .arg(hex, -int(3 * std::min(kBytesInLine, bytes.size()) - 1))
                    .arg(asciiOf(line));
    }
    return text;
}

} // namespace trundle
