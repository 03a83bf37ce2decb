scripts/install puts the program, its manual and the completion of three shells below a prefix. SCC names a program that
is there, so that nothing is built here.

  $ scripts=$PWD/../../scripts
  $ export SCC=$(command -v scc)
  $ mkdir home; export HOME=$PWD/home
  $ "$scripts/install" prefix | sed "s|$PWD|.|g"
  scc is in ./prefix/bin; its manual: man scc, man scc-check
  that is not in your PATH yet: export PATH="./prefix/bin:$PATH"
  $ find prefix -type f | LC_ALL=C sort
  prefix/bin/scc
  prefix/share/bash-completion/completions/scc
  prefix/share/fish/vendor_completions.d/scc.fish
  prefix/share/man/man1/scc-check.1
  prefix/share/man/man1/scc-compare.1
  prefix/share/man/man1/scc-conform.1
  prefix/share/man/man1/scc-decompose.1
  prefix/share/man/man1/scc-diff.1
  prefix/share/man/man1/scc-estimate.1
  prefix/share/man/man1/scc-explain.1
  prefix/share/man/man1/scc-explore.1
  prefix/share/man/man1/scc-export.1
  prefix/share/man/man1/scc-fmt.1
  prefix/share/man/man1/scc-inflate.1
  prefix/share/man/man1/scc-lsp.1
  prefix/share/man/man1/scc-oracle.1
  prefix/share/man/man1/scc-serve.1
  prefix/share/man/man1/scc-shape.1
  prefix/share/man/man1/scc-simulate.1
  prefix/share/man/man1/scc-successors.1
  prefix/share/man/man1/scc-sweep.1
  prefix/share/man/man1/scc-trace.1
  prefix/share/man/man1/scc-translate.1
  prefix/share/man/man1/scc-view.1
  prefix/share/man/man1/scc.1
  prefix/share/scc/installed
  prefix/share/zsh/site-functions/_scc
  $ prefix/bin/scc --version
  0.1.0 (semantics 3)

The pages are those of the program, and groff finds nothing wrong with them:

  $ for page in prefix/share/man/man1/*.1; do
  >   name=$(basename $page .1)
  >   grep -q "^\.TH \"$(echo $name | tr a-z A-Z)\" 1" $page || echo "$page: no title"
  >   if command -v groff > /dev/null; then groff -man -ww -K utf8 -T utf8 $page 2>&1 > /dev/null; fi
  > done
  $ scc check --help=groff | diff - prefix/share/man/man1/scc-check.1
  10c10
  < scc\N'45'check \N'45' explore a model and verify its properties
  ---
  > scc\-check \- explore a model and verify its properties
  [1]

Each command and each option of its manual is known to each shell, and the shells can read what is written for them.

  $ bash=prefix/share/bash-completion/completions/scc
  $ zsh=prefix/share/zsh/site-functions/_scc
  $ fish=prefix/share/fish/vendor_completions.d/scc.fish
  $ python3 -B completions.py scc $bash $zsh $fish
  $ bash -n $bash
  $ for shell in zsh fish; do
  >   if command -v $shell > /dev/null; then eval file='$'$shell; $shell -n $file || echo "$shell cannot read it"; fi
  > done

bash takes an equals sign for a word of its own, as it does at a prompt:

  $ cat > complete.bash <<'END'
  > source "$1"
  > shift
  > COMP_WORDS=("$@")
  > COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  > _scc
  > ((${#COMPREPLY[@]} == 0)) || printf '%s\n' "${COMPREPLY[@]}" | LC_ALL=C sort | paste -sd ' '
  > END
  $ complete() { bash complete.bash $bash "$@"; }
  $ touch 'a model.sc' model.sc; mkdir models
  $ complete scc ''
  --help --version check compare conform decompose diff estimate explain explore export fmt inflate lsp oracle serve shape simulate successors sweep trace translate view
  $ complete scc ex
  explain explore export
  $ complete scc check --s
  --sarif --seconds --shortest --slice --smt --states --stats --store
  $ complete scc check --color = ''
  always auto never
  $ complete scc check --color = al
  always
  $ complete scc compare --modulo =
  branching strong timed trace weak
  $ complete scc compare --modulo t
  timed trace
  $ complete scc explore --format ''
  aut dot drn json tra
  $ complete scc simulate --format ''
  csv jsonl
  $ complete scc inflate --pieces = ''
  apart each one plate
  $ complete scc trace --states e
  ends
  $ complete scc check mo
  model.sc models
  $ complete scc check 'a '
  a model.sc
  $ complete scc check --witness mo
  models
  $ complete scc check --stats model
  model.sc models
  $ complete scc check --states ''
  $ complete scc --help ''
  --help --version check compare conform decompose diff estimate explain explore export fmt inflate lsp oracle serve shape simulate successors sweep trace translate view

fish, where it is there, tells what each is for:

  $ if command -v fish > /dev/null; then
  >   fish -c "source $fish; complete -C 'scc check --stat'; complete -C 'scc shap'"
  > else
  >   printf -- '--states\tKeeps at most N states\n'
  >   printf -- '--stats\tTells what the run took: seconds of each phase, states and transitions a second, memory\n'
  >   printf 'shape\treport on a polyhedron\n'
  > fi
  --states	Keeps at most N states
  --stats	Prints what the run cost: seconds of each phase, states and transitions a second, memory
  shape	report on a polyhedron

Installing again replaces what is there, also what an earlier version had beside it; nothing else is touched. From here
on SCC prints its pages, and is not asked for the values of each option, which takes most of the time.

  $ mkdir pages; cat > pages/scc <<END
  > #!/bin/sh
  > case "\$*" in *--help=*) exec "$SCC" "\$@" ;; esac
  > END
  $ chmod +x pages/scc; SCC=$PWD/pages/scc
  $ touch prefix/share/man/man1/scc-old.1 prefix/share/man/man1/other.1
  $ echo share/man/man1/scc-old.1 >> prefix/share/scc/installed
  $ echo 'not scc' > prefix/bin/scc
  $ PATH=$PWD/prefix/bin:$PATH "$scripts/install" "$PWD/prefix" | sed "s|$PWD|.|g"
  scc is in ./prefix/bin; its manual: man scc, man scc-check
  $ cmp prefix/bin/scc "$SCC"
  $ ls prefix/share/man/man1 | grep o
  other.1
  scc-compare.1
  scc-conform.1
  scc-decompose.1
  scc-explore.1
  scc-export.1
  scc-oracle.1
  scc-successors.1

  $ "$scripts/uninstall" prefix | sed "s|$PWD|.|g"
  scc is no longer in ./prefix
  $ find prefix | LC_ALL=C sort
  prefix
  prefix/share
  prefix/share/man
  prefix/share/man/man1
  prefix/share/man/man1/other.1
  $ "$scripts/uninstall" prefix 2>&1 | sed "s|$PWD|.|g"
  scripts/install: nothing is installed in ./prefix (./prefix/share/scc/installed is not there)
  $ "$scripts/uninstall" prefix 2> /dev/null
  [1]

Without a prefix it is ~/.local, and /usr/local for root (which is not tried here):

  $ if [ $(id -u) -ne 0 ]; then "$scripts/install" > /dev/null; else "$scripts/install" "$HOME/.local" > /dev/null; fi
  $ ls home/.local/bin
  scc
  $ "$scripts/install" --uninstall "$HOME/.local" > /dev/null
  $ find home -name bin -o -name man -o -name man1 -o -name zsh -o -name '*completion*' -o -name '*scc*'
  $ "$scripts/install" --nothing
  scripts/install: no option '--nothing'
  usage: scripts/install [--uninstall] [PREFIX]
  [64]
  $ "$scripts/install" a b
  scripts/install: more than one PREFIX: 'a' and 'b'
  usage: scripts/install [--uninstall] [PREFIX]
  [64]
  $ "$scripts/completion" scc csh
  scripts/completion: no shell 'csh': bash, zsh and fish are known
  [64]

scripts/run checks all models of a folder, and ends with one line.

  $ mkdir some; cp ../../specs/models/dimer.sc ../../specs/models/slot.sc ../../specs/models/escape.sc some
  $ "$scripts/check-models" scc some 2>&1 | tail -n 1
  3 models with 22 checks: all as expected
  $ sed -i '0,/expect: holds/s//expect: violated/' some/dimer.sc
  $ echo 'check extra : possibly time > 1' >> some/dimer.sc
  $ echo 'shape' > some/wrong.sc
  $ "$scripts/check-models" scc some > told 2>&1
  [1]
  $ grep -E 'check-models|models with' told
  check-models: some/dimer.sc: extra: the model does not say what to expect
  check-models: some/dimer.sc: born: holds, and violated was expected
  check-models: some/wrong.sc: exit code 3
  4 models with 23 checks: 2 not as expected
