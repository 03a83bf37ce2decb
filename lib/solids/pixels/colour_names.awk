# The module Colour_names, of the table colour_names.txt.

BEGIN { print "let all =\n  [" }
{ printf "    (\"%s\", 0x%s);\n", $1, $2 }
END { print "  ]" }
