# The module Code, of the table codes.txt: awk -v part=ml -f codes.awk codes.txt, and likewise part=mli.

BEGIN {
  if (part == "ml") print "type t = string\n"
  else {
    print "(** The stable codes of diagnostics ([codes.txt]). A code, once released, keeps its meaning. *)\n"
    print "type t = private string\n"
    print "val all : (t * string) list"
    print "(** Every code with the fault that it stands for, in order. *)"
  }
}

function finish() {
  if (name && part == "ml") print "let " name " = \"" code "\""
  else if (name) print "\nval " name " : t\n(** " code ": " fault (note ? " (" note ")" : "") ". *)"
  if (name) all = all "    (" name ", \"" fault "\");\n"
  name = note = ""
}

/^SC/ { finish(); code = $1; name = $2; fault = $3; for (i = 4; i <= NF; i++) fault = fault " " $i }
/^    / { sub(/^ +/, ""); note = $0 }
/^= / { finish(); if (part == "mli") print "\n(** {1 " substr($0, 3) "} *)" }

END {
  finish()
  if (part == "ml") printf "\nlet all =\n  [\n%s  ]\n", all
}
