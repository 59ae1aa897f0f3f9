# Writes the table of the line's symbols for its program. usage: awk -f table.awk ../body-shop.csv >table.h
#
# A device has its symbols in a row of the list, and devices of one shape have the same symbols. So the table has, for each
# shape, the places of its symbols in a device, and for each station where its devices of each shape begin.

BEGIN { FS = "," }

$2 ~ /^BODY_/ {
  split($2, level, "_")
  place = level[2]
  shape = level[3]
  sub(/[0-9]+$/, "", shape)
  if (!(place in seen)) { station[++stations] = place; seen[place] = 1 }
  if (!(shape in first_of)) { shapes[++shape_count] = shape; first_of[shape] = level[3] place }
  if (!((place, level[3]) in known)) {
    known[place, level[3]] = 1
    if (many[place, shape]++ == 0) begin[place, shape] = symbols
  }
  if (first_of[shape] == level[3] place) task[shape, ++tasks[shape]] = level[4] "_" level[5]
  writes = level[4] == "O" ? ", .writes = 1" : ""
  variables = variables sprintf("    {.symbol = \"%s\"%s, .bits = %d},\n", $2, writes, $5 == "BOOL" ? 1 : 16)
  ++symbols
}

END {
  print "/* The symbols of the line, its stations and their devices. Written by table.awk from body-shop.csv: edit that script. */"
  print "#include <symplant/program.h>\n"
  print "/* The shapes of devices, and the places of their symbols. */"
  printf "enum shape {"
  for (s = 1; s <= shape_count; s++) printf " %s,", shapes[s]
  print " SHAPES };"
  for (s = 1; s <= shape_count; s++) {
    printf "enum {"
    for (t = 1; t <= tasks[shapes[s]]; t++) printf " %s_%s,", shapes[s], task[shapes[s], t]
    printf " %s_SYMBOLS };\n", shapes[s]
  }
  printf "static const short symbols_of[SHAPES] = {"
  for (s = 1; s <= shape_count; s++) printf "%s%s_SYMBOLS", s == 1 ? "" : ", ", shapes[s]
  print "};\n"
  print "/* The kinds of stations. */"
  printf "enum kind {"
  for (s = 1; s <= stations; s++) {
    kind = station[s]
    sub(/[0-9]+$/, "", kind)
    if (!(kind in kinds)) { kinds[kind] = 1; printf " %s,", kind }
  }
  print " KINDS };\n"
  print "struct devices { short first, count; }; /* the variable of the first symbol of the first one */"
  print "struct place { const char *name; enum kind kind; struct devices devices[SHAPES]; };\n"
  printf "enum { STATIONS = %d, VARIABLES = %d };\n", stations, symbols
  print "static const struct place places[STATIONS] = {"
  for (s = 1; s <= stations; s++) {
    kind = station[s]
    sub(/[0-9]+$/, "", kind)
    printf "    {\"%s\", %s, {", station[s], kind
    separator = ""
    for (d = 1; d <= shape_count; d++) {
      if (!((station[s], shapes[d]) in many)) continue
      printf "%s[%s] = {%d, %d}", separator, shapes[d], begin[station[s], shapes[d]], many[station[s], shapes[d]]
      separator = ", "
    }
    print "}},"
  }
  print "};\n"
  print "static const struct symplant_variable variables[VARIABLES] = {"
  printf "%s", variables
  print "};"
}
