# The module Quotas, of the table quotas.txt: awk -v part=ml -f quotas.awk quotas.txt, and likewise part=mli.

/^[^#]/ {
  name = $1; sub(/^[^ ]+ /, "")
  fields = fields "  " name " : int;\n"
  numbers = numbers "    " name " = " $0 ";\n"
  list = list "    (\"" name "\", q." name ");\n"
}

END {
  if (part == "ml") {
    print "type t = {\n" fields "}\n"
    print "let mib = Scc_base.Memory.mib\n"
    print "let default =\n  {\n" numbers "  }\n"
    print "let listed q =\n  [\n" list "  ]\n"
    print "let default_states = 100_000"
  } else {
    print "(** The limits of the service (see [specs/oracle.md]). A request beyond a limit is refused before any work"
    print "    is done. *)\n"
    print "(** The limits by name. *)"
    print "type t = {\n" fields "}\n"
    print "val default : t\n(** The limits of [specs/oracle.md]. *)\n"
    print "val listed : t -> (string * int) list\n(** The limits with the names of their fields. *)\n"
    print "val default_states : int"
    print "(** The limit of states for the exploration of a temporal formula, unless the request sets another: 100 000. *)"
  }
}
