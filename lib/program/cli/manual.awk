# The module Manual: a list of blocks for each of the texts of the manual. A text has blocks with empty lines between:
#
#   = TITLE        a section
#   @ NAME         the blocks of the text NAME, which comes before
#   - TERM         an item, explained by the lines below, which are indented by two
#       line       lines as they are, indented by four, of which two are kept
#   any other      a paragraph

BEGIN { print "open Cmdliner" }

function finish() {
  if (kind == "P") print "    `P {m|" text "|m};"
  if (kind == "I") print "    `I ({m|" term "|m}, {m|" text "|m});"
  if (kind == "Pre") print "    `Pre {m|" text "|m};"
  kind = text = ""
}

function close_text() { finish(); if (NR > 1) print "  ]" }

FNR == 1 {
  close_text()
  name = FILENAME; sub(/.*\//, "", name); sub(/\.txt$/, "", name)
  print "\nlet " name " : Manpage.block list =\n  ["
}

/^$/ { finish(); next }
/^= / { finish(); print "    `S {m|" substr($0, 3) "|m};"; next }
/^@ / { finish(); print "    `Blocks " $2 ";"; next }
/^- / { finish(); kind = "I"; term = substr($0, 3); next }
/^    / { text = text (kind == "Pre" ? "\n" : "") substr($0, 3); kind = "Pre"; next }
{ sub(/^ +/, ""); if (kind == "") kind = "P"; text = text (text == "" ? "" : " ") $0 }

END { close_text() }
