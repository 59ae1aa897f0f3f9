// Rows of the material flow.
#include "elements/material/rows.hpp"

#include <string_view>

#include "emit/row_text.hpp"
#include "text/identifier.hpp"

namespace symplant::emit {
namespace {

std::string_view location_name(const model::Material& material, std::uint32_t location) {
  return location == tables::kOut ? std::string_view("out") : std::string_view(material.location_name(location));
}

/// The track of each of its rows, for comments.
template <class RowsOf, class Row>
void for_tracks(const lower::EngineTables& tables, RowsOf rows_of, Row row) {
  for (std::uint32_t t = 0; t < tables.material.tracks.size(); ++t) {
    const tables::Rows of = rows_of(tables.material.tracks[t]);
    for (std::uint32_t r = of.first; r < of.first + of.count; ++r) row(t, r);
  }
}

/// Enumerators with the values 0, 1, ...; a name that is taken gets a suffix.
template <class NameOf>
std::string constant_rows(std::size_t count, NameOf name_of) {
  RowWriter rows;
  text::IdentifierScope scope;
  for (std::size_t i = 0; i < count; ++i) {
    rows.text("  ").text(scope.unique(name_of(i))).text(" = ").number(i).text(",\n");
  }
  return rows.take();
}

}  // namespace

std::string part_kind_rows(const model::Material& material) {
  RowWriter rows;
  for (const model::PartKind& kind : material.kinds) {
    row_text(rows, tables::KindRow{kind.length, kind.code, kind.weight}).comment(kind.name).text("\n");
  }
  return rows.take();
}

std::string track_rows(const lower::EngineTables& tables, const model::Material& material) {
  RowWriter rows;
  for (std::size_t t = 0; t < material.tracks.size(); ++t) {
    row_text(rows, tables.material.tracks[t]).comment(material.tracks[t].name).text("\n");
  }
  return rows.take();
}

std::string drive_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for_tracks(
      tables, [](const tables::TrackRow& row) { return row.drives; },
      [&](std::uint32_t track, std::uint32_t r) {
        const tables::DriveRow& row = tables.material.drives[r];
        row_text(rows, row).comment(plant.material.tracks[track].name);
        if (row.symbol != tables::kNone) rows.text(", speed of ").comment(plant.symbols[row.symbol].name());
        if (row.output != tables::kNone) rows.text(", speed of ").comment(model::output_name(plant, row.output));
        rows.text("\n");
      });
  return rows.take();
}

std::string stop_rows(const lower::EngineTables& tables, const model::Material& material) {
  RowWriter rows;
  for_tracks(
      tables, [](const tables::TrackRow& row) { return row.stops; },
      [&](std::uint32_t track, std::uint32_t r) {
        row_text(rows, tables.material.stops[r]).comment(material.tracks[track].name).text("\n");
      });
  return rows.take();
}

std::string end_rows(const lower::EngineTables& tables, const model::Material& material) {
  RowWriter rows;
  for_tracks(
      tables, [](const tables::TrackRow& row) { return row.ends; },
      [&](std::uint32_t track, std::uint32_t r) {
        const tables::EndRow& row = tables.material.ends[r];
        row_text(rows, row).comment(material.tracks[track].name).text(" to ");
        rows.comment(location_name(material, row.to)).text("\n");
      });
  return rows.take();
}

std::string part_sensor_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::SensorRow& row : tables.material.sensors) {
    row_text(rows, row).comment(plant.symbols[row.symbol].name()).text(" at ");
    rows.comment(plant.material.location_name(row.location)).text("\n");
  }
  return rows.take();
}

std::string place_rows(const lower::EngineTables& tables, const model::Material& material) {
  RowWriter rows;
  for (std::size_t p = 0; p < material.places.size(); ++p) {
    row_text(rows, tables.material.places[p]).comment(material.places[p].name).text("\n");
  }
  return rows.take();
}

std::string transfer_rows(const lower::EngineTables& tables, const model::Material& material) {
  RowWriter rows;
  for (std::size_t t = 0; t < material.transfers.size(); ++t) {
    const tables::TransferRow& row = tables.material.transfers[t];
    row_text(rows, row).comment(material.transfers[t].name).text(": ");
    rows.comment(location_name(material, row.from.location))
        .text(" to ")
        .comment(location_name(material, row.to.location))
        .text("\n");
  }
  return rows.take();
}

std::string work_rows(const lower::EngineTables& tables, const model::Material& material) {
  RowWriter rows;
  for (std::size_t w = 0; w < material.work.size(); ++w) {
    const tables::WorkRow& row = tables.material.work[w];
    row_text(rows, row).comment(material.work[w].name).text(": ").comment(material.kinds[row.from].name).text(" to ");
    rows.comment(material.kinds[row.to].name).text("\n");
  }
  return rows.take();
}

std::string source_rows(const lower::EngineTables& tables, const model::Material& material) {
  RowWriter rows;
  for (std::size_t s = 0; s < material.sources.size(); ++s) {
    row_text(rows, tables.material.sources[s]).comment(material.sources[s].name).text("\n");
  }
  return rows.take();
}

std::string kind_number_rows(const std::vector<std::uint32_t>& kinds, const model::Material& material) {
  RowWriter rows;
  for (const std::uint32_t kind : kinds) {
    rows.text("    ").number(kind).text(",  // ").comment(material.kinds[kind].name).text("\n");
  }
  return rows.take();
}

std::string part_counter_rows(const lower::EngineTables& tables, const model::Material& material) {
  RowWriter rows;
  for (const tables::PartCounterRow& row : tables.material.counters) {
    row_text(rows, row).comment(material.location_name(row.location)).text(row.kind == tables::kNone ? ".parts" : ".");
    if (row.kind != tables::kNone) rows.comment(material.kinds[row.kind].name);
    rows.text("\n");
  }
  return rows.take();
}

std::string location_constant_rows(const model::Material& material) {
  return constant_rows(material.locations(),
                       [&](std::size_t i) { return material.location_name(static_cast<std::uint32_t>(i)); });
}

std::string part_kind_constant_rows(const model::Material& material) {
  return constant_rows(material.kinds.size(), [&](std::size_t i) { return material.kinds[i].name; });
}

}  // namespace symplant::emit
