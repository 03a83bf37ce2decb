# The module Forms, of the table forms.txt.

BEGIN {
  print "type category = Written | Called | Event | Choice"
  print "type entry = { category : category; word : string; forms : string list }\n"
  print "let all =\n  ["
}

/^= / { category = $2; next }

/^[^#]/ {
  word = $0; sub(/:.*/, "", word); sub(/^[^:]*: /, "")
  printf "    { category = %s; word = \"%s\"; forms = [", category, word
  count = split($0, forms, / ;; /)
  for (i = 1; i <= count; i++) printf "%s {f|%s|f}", (i > 1 ? ";" : ""), forms[i]
  print " ] };"
}

END {
  print "  ]\n"
  print "let find category word ="
  print "  List.find_opt (fun e -> e.category = category && String.equal e.word word) all"
  print "  |> Option.map (fun e -> e.forms)"
}
