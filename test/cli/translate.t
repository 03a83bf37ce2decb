A model in another notation:

  $ cat > p.sc <<'END'
  > process   p = Cube   [ nil ] // alone
  > END
  $ scc translate p.sc
  process p = Cube [nil] // alone
  $ scc translate p.sc -o q.sc && cat q.sc
  process p = Cube [nil] // alone
  $ scc translate - < p.sc --to sc
  process p = Cube [nil] // alone
