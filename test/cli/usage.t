Every mistake on the command line ends with exit code 64, whatever the command, and is told on standard error.

  $ echo 'P1 1 1 1' > icon.pbm
  $ cat > cube.sc <<'END'
  > param m = 1
  > shape Cube {
  >   vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
  >            e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  >   faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
  >            right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
  > }
  > compound Pair { part one : Cube mass 1 part two : Cube mass 1 at translate (2,0,0) glue one.right ~ two.left }
  > process p = Cube mass m velocity (1,0,0) [nil]
  > check goes : possibly x(p) > 3
  > END
  $ scc check cube.sc --witness runs > check.out 2>&1
  $ scc trace cube.sc -o run.jsonl 2> /dev/null
  $ scc explore cube.sc -o graph.aut 2> /dev/null
  $ scc shape cube.sc:Cube -o box.off > /dev/null

The arguments of each command that make it succeed, without options:

  $ arguments() {
  >   case $1 in
  >     check | trace | fmt | translate | serve) echo cube.sc ;;
  >     view) echo -o page.html cube.sc ;;
  >     export) echo --steps 20 -o run.glb cube.sc ;;
  >     explore) echo cube.sc -o out.aut ;;
  >     explain) echo runs/goes.json cube.sc ;;
  >     compare) echo cube.sc cube.sc ;;
  >     conform) echo cube.sc run.jsonl ;;
  >     diff) echo run.jsonl run.jsonl ;;
  >     shape) echo cube.sc:Cube ;;
  >     inflate) echo icon.pbm ;;
  >     decompose) echo box.off ;;
  >     oracle) ;;
  >     successors) echo cube.sc ;;
  >   esac
  > }
  $ commands='check trace view export explore explain compare conform diff shape inflate decompose oracle successors fmt translate'
  $ scc --help=plain | sed -n '/^COMMANDS/,/^COMMON/s/^       \([a-z]*\) .*/\1/p' | sort | xargs
  check compare conform decompose diff estimate explain explore export fmt inflate lsp oracle serve shape simulate successors sweep trace translate view
  $ for c in $commands; do scc $c $(arguments $c) < /dev/null > out 2> err || echo "$c: $?"; done

misuse WORDS: each of those commands, with its arguments and these words. What does not end with 64, or says nothing,
or says something on standard output, is printed.

  $ misuse() {
  >   for c in $those; do
  >     code=0
  >     scc $c $(arguments $c) "$@" < /dev/null > out 2> err || code=$?
  >     [ $code = 64 ] && [ -s err ] && [ ! -s out ] || { echo "$c $*: exit $code"; head -n 2 out err; }
  >   done
  > }

No such option; one given twice; a flag with a value; an option without its value:

  $ those="$commands serve"
  $ misuse --no-such-option
  $ misuse --help=nothing
  $ those='check trace view serve export explore explain compare conform diff shape inflate fmt translate'
  $ misuse --color=sometimes
  $ misuse --color=never --color=never
  $ misuse --color
  $ those='check explain compare conform diff shape inflate'
  $ misuse --json=yes
  $ misuse --json --json

Too many arguments, and none:

  $ those='check trace view serve export explore explain compare conform diff shape inflate oracle translate'
  $ misuse a b c
  $ for c in check trace view export explore explain compare conform diff shape inflate fmt translate; do
  >   scc $c > out 2>&1; [ $? = 64 ] || echo "$c"
  > done

Parameters: not of the form, no number, a division by zero, twice, and one that the model does not have.

  $ those='check trace view export explore explain compare conform shape'
  $ misuse -D
  $ misuse -D m
  $ misuse -D =1
  $ misuse -D m=
  $ misuse -D m=one
  $ misuse -D m=1/0
  $ misuse -D m=1e1000000000
  $ misuse -D unknown=1
  $ misuse -D n=1
  $ those='check trace explore compare'
  $ misuse -D m=1 -D m=2
  $ those='compare'
  $ misuse --left unknown=1
  $ misuse --right unknown=1
  $ misuse --left m=1 -D m=1
  $ scc compare graph.aut graph.aut -D m=1
  command line: error[SC0209]: graph.aut is a graph, and has no parameters that could be given a value
  [64]
  $ scc check cube.sc -D n=1
  command line: error[SC0209]: the model has no parameter `n`
    hint: did you mean `m`?
  [64]
  $ scc check cube.sc -D n=1 --json
  {
    "format": "scc-diagnostics",
    "version": 1,
    "exit": 64,
    "diagnostics": [
      {
        "code": "SC0209",
        "severity": "error",
        "message": "the model has no parameter `n`",
        "place": {"file": "command line", "start": {"offset": 0}, "end": {"offset": 0}},
        "notes": [],
        "hint": "did you mean `m`?"
      }
    ]
  }
  [64]

A value other than that of the recorded run:

  $ scc explain runs/goes.json cube.sc -D m=2
  command line: error[SC0801]: the schedule was made with another value of `m` than -D gives
  runs/goes.json:1:1: note: it is here
     |
   1 | { "format": "scc-schedule",
     | ^
  [64]
  $ scc trace cube.sc --schedule runs/goes.json -D m=2
  command line: error[SC0801]: the schedule was made with another value of `m` than -D gives
  runs/goes.json:1:1: note: it is here
     |
   1 | { "format": "scc-schedule",
     | ^
  [64]
  $ scc conform cube.sc run.jsonl -D m=2
  command line: error[SC0804]: the trace was made with another value of `m` than -D gives
  [64]

A wrong value of a parameter that is there makes an invalid model:

  $ scc check cube.sc -D m=-1 2>&1 | head -n 1
  cube.sc:9:23: error[SC0208]: the mass must be positive, and it is -1
  $ scc check cube.sc -D m=-1 > out 2>&1
  [3]

Numbers that are none, or out of their range:

  $ those='check explore compare'
  $ for option in --depth --time --states --seconds --memory --bits --jobs; do
  >   misuse $option=some; misuse $option=-1; misuse $option=
  > done
  $ for option in --states --seconds --memory --bits; do misuse $option=0; done
  $ those=trace
  $ misuse --steps=-1
  $ misuse --steps=1.5
  $ misuse --time=-1
  $ misuse --choose=last
  $ misuse --choose=random:x
  $ misuse --states=some
  $ misuse --human --itf
  $ those='conform diff'
  $ misuse --tolerance=-1
  $ misuse --tolerance=some
  $ those=conform
  $ misuse --states=0
  $ misuse --unobserved=
Seconds are a decimal or a fraction:

  $ echo 'fixed p = box(1, 1, 1) [nil]' > still.sc
  $ scc check still.sc --seconds 1/2 | tail -1
  no properties to check
  $ those=check
  $ misuse --seconds=1/0
  $ misuse --seconds=-1/2

  $ those=successors
  $ misuse --framing=words
  $ misuse --exploration=0
  $ misuse --check
  $ misuse --no-reduce=everything
  $ misuse --bits=0
  $ misuse --check=none
  $ those=oracle
  $ misuse --seconds=0
  $ misuse --memory=none
  $ misuse --line-bytes=0

Names:

  $ those=check
  $ misuse --no-reduce=everything
  $ misuse --shortest=way
  $ misuse --witness out --no-reduce jump
  $ those='shape decompose inflate'
  $ for value in some -1 0 ''; do misuse --memory=$value; done
  $ those=inflate
  $ misuse --faces 5
  $ misuse --faces some
  $ misuse --scale 0
  $ misuse --profile flat
  $ misuse --strength=-1
  $ misuse --strength red=1
  $ misuse --strength '#ff000=1'
  $ misuse --strength 1 --strength 2
  $ misuse --strength '#ff0000=1' --strength '#FF0000=2'
  $ misuse --background red
  $ misuse --piece 0
  $ misuse --resolution 100000
  $ misuse -o solid.txt
  $ those='view shape'
  $ misuse --svg 1 --from 0,0,0
  $ misuse --svg 1 --from 1,0
  $ misuse --svg 1 --from=1,0,1/0
  $ misuse --svg 1 --up=1,2,3,4
  $ misuse --svg 1 --width=10
  $ misuse --svg 1 --width=100000
  $ misuse --from 1,1,1
  $ misuse --width 500
  $ those=view
  $ misuse --svg=-1
  $ misuse --names
  $ those=serve
  $ misuse --port=0
  $ misuse --port=65536
  $ misuse --port=http
  $ misuse --seconds=0
  $ misuse -D m
  $ misuse -D m=1 -D m=2
  $ misuse --task=nothing
  $ scc serve - < /dev/null; [ $? = 64 ]
  scc: standard input cannot be served: the model is a file
  $ those=explore
  $ misuse --format=png
  $ misuse --dialect=mine
  $ misuse --hide=
  $ those=compare
  $ misuse --modulo=nothing
  $ misuse --rename=p
  $ misuse --rename=p=
  $ misuse '--rename=p=*'
  $ those=explain
  $ misuse --check=gose
  $ those=translate
  $ misuse --to
  $ misuse --to=nothing
  $ those=fmt
  $ misuse --check -i
  $ misuse --check --check
  $ for arguments in 'explore cube.sc' 'explore cube.sc -o graph' 'explore cube.sc -o graph.png' 'explore cube.sc -o -' \
  >   'explore cube.sc -o - --format tra' 'compare - -' 'conform - -' 'diff - -' 'fmt -i -' \
  >   'shape cube.sc' 'shape cube.sc:Nothing' 'shape cube.sc:Pair' \
  >   'shape cube.sc:Cube --faces 9' 'shape cube.sc:Cube --hull --faces 3' 'shape cube.sc:Cube --hull --faces all' \
  >   'shape cube.sc:Cube --hull --faces 9 --snap 1' 'shape cube.sc:Cube --hull --faces 1001' \
  >   'shape cube.sc:Cube --svg' 'shape cube.sc:Cube --svg -' '' 'chekc cube.sc' '--nothing'; do
  >   scc $arguments < /dev/null > out 2>&1; [ $? = 64 ] || { echo "scc $arguments"; cat out; }
  > done
  $ scc explain runs/goes.json cube.sc --check gose 2>&1 | tail -n 2
  command line: error[SC0201]: the model has no check `gose`
    hint: did you mean `goes`?
  $ scc shape cube.sc:Nothing
  command line: error[SC0201]: unknown template `Nothing`
  [64]
  $ scc shape cube.sc
  command line: error[SC0210]: cube.sc is a model (its templates: Cube), and a single shape is needed here
    hint: name one of them: cube.sc:Cube
  [64]
