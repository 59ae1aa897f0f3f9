// Reads global labels of GX Works2 and GX Works3.
#include "read/formats.hpp"
#include "read/formats/table_formats.hpp"

namespace symplant::read {

namespace {

constexpr std::array kGxWorksLabelsHeaders{
    HeaderWords{"class", "labelname", "datatype", "assign(devicelabel)"},
    HeaderWords{"class", "labelname", "datatype", "device"}, HeaderWords{"클래스", "라벨명", "데이터형", "디바이스"},
    HeaderWords{"クラス", "ラベル名", "データ型", "デバイス"}, HeaderWords{"类", "标签名", "数据类型", "软元件"}};

int gx_works_labels_likelihood(std::string_view text) {
  return layout_in_any(text, kGxWorksLabelsHeaders) ? kKnownHeader : 0;
}

std::optional<SymbolTable> read_gx_works_labels(const Reading& reading) {
  const auto layout = layout_in_any(reading.source->text(), kGxWorksLabelsHeaders);
  if (!layout) return kAnyTable.read(reading);
  return read_table(reading, *layout, {.notation = address::Notation::melsec, .sort_addresses = true});
}

}  // namespace

const ReaderInfo kGxWorksLabels{"gx-works-labels", "GX Works global labels", gx_works_labels_likelihood,
                                read_gx_works_labels};

}  // namespace symplant::read
