# The module Language_words, of the table language_words.txt: awk -v part=ml -f language_words.awk FILE. With
# part=tokens, the tokens of the lexer for its words.

BEGIN {
  print "let all =\n  ["
}

/^[^#]/ {
  if (part == "tokens") printf "    (\"%s\", Parser.%s);\n", $1, $2 == "LETTER" ? "LETTER \"" $1 "\"" : $2
  else printf "    (\"%s\", %s);\n", $1, $3 == "name" ? "true" : "false"
}

END {
  print "  ]"
  if (part == "ml") print "\nlet is_reserved word = List.mem (word, false) all"
}
