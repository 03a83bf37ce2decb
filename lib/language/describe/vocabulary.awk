# The module Vocabulary, of the table vocabulary.txt.

BEGIN {
  print "type category = Word | Setting | Solid | Function | Component | Atom | Law | Event | Measure"
  print "type entry = { category : category; word : string; kind : string; section : string; meaning : string }\n"
  print "let all =\n  ["
}

/^= / { category = $2; kind = $3; sub(/^= [^ ]+ [^ ]+ /, ""); section = $0; next }

/^[^#]/ {
  word = $0; sub(/:.*/, "", word); sub(/^[^:]*: /, "")
  printf "    { category = %s; word = \"%s\"; kind = \"%s\"; section = \"%s\"; meaning = {w|%s|w} };\n",
    category, word, kind, section, $0
}

END {
  print "  ]\n"
  print "let find category word = List.find_opt (fun e -> e.category = category && String.equal e.word word) all"
}
