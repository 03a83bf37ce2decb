A page is one file of HTML, named after the model; its data alone is JSON. The pages themselves are tested in a browser
(test/web).

  $ models=../../specs/models
  $ scc view $models/chain.sc
  scc: wrote chain.html
  $ head -c 15 chain.html; echo; grep -c 'Content-Security-Policy' chain.html
  <!DOCTYPE html>
  1
  $ scc view $models/chain.sc --data -o - | head -c 21
  {"format":"scc-view",
  $ scc view $models/chain.sc --data -o a.json; scc view $models/chain.sc --data -o b.json; cmp a.json b.json
  scc: wrote a.json
  scc: wrote b.json

The runs are those of the checks, and one by the first choices; or that of a schedule or a trace alone.

  $ runs() { tr -d '\n' < $1 | grep -o '"name":"[a-z_ ]*","check"' | cut -d '"' -f 4 | paste -sd ' '; }
  $ scc view $models/hexokinase.sc --data -o h.json 2> err; runs h.json
  reaction in_time together at_most full surely releases in_pocket first choices
  $ scc view $models/hexokinase.sc --check surely --data -o h.json 2> err; runs h.json
  surely first choices
  $ scc check $models/hexokinase.sc --witness runs > out; [ $? = 1 ]
  $ scc view $models/hexokinase.sc --schedule runs/surely.json --data -o h.json 2> err; runs h.json
  surely
  $ scc trace $models/hexokinase.sc -o run.jsonl
  $ scc view $models/hexokinase.sc --trace run.jsonl --data -o h.json 2> err; runs h.json
  run

What looks alike is of one family: by its name without an index, and of more than ten names by its template.

  $ families() { grep '^"families"' $1; }
  $ families h.json
  "families":["atp","glucose","enzyme"],
  $ cat > many.sc <<'END'
  > shape Cube {
  >   vertices a (-1,-1,-1) b (1,-1,-1) c (1,1,-1) d (-1,1,-1) e (-1,-1,1) f (1,-1,1) g (1,1,1) h (-1,1,1)
  >   faces bottom [a,d,c,b] top [e,f,g,h] left [a,e,h,d] right [b,c,g,f] front [a,b,f,e] back [d,h,g,c]
  > }
  > END
  $ i=0; for name in a b c d e f g h j k l; do i=$((i + 3)); echo "process $name = Cube mass 1 at translate ($i, 0, 0) [nil]"; done >> many.sc
  $ scc view many.sc --data -o many.json 2> err; families many.json
  "families":["Cube"],

Numbers that are plotted are those that the checks name, and others.

  $ scc view $models/hexokinase.sc --plot 'distance2(atp, glucose)' --plot time --data -o h.json 2> err
  $ grep '^"plots"' h.json | cut -c 1-60
  "plots":[{"text":"distance2(atp, glucose)"},{"text":"time"},
  $ scc view $models/hexokinase.sc --plot 'x(adp)'
  --plot x(adp):1:3: error[SC0201]: unknown process `adp`
     |
   1 | x(adp)
     |   ^^^
    hint: did you mean `atp`?
  [3]
  $ scc view $models/hexokinase.sc --plot 'bound(atp, enzyme)' 2>&1 | head -n 1
  --plot bound(atp, enzyme):1:1: error[SC0208]: this is no number: a plot shows a number over time

A picture of one state:

  $ scc view $models/hexokinase.sc --svg 2 --check reaction -o r.svg; head -c 5 r.svg; echo
  scc: wrote r.svg
  <svg 
  $ scc view $models/billiard.sc --svg 100000 --check nothing
  command line: error[SC0201]: the model has no check `nothing`
  [64]
  $ scc view $models/hexokinase.sc --svg 1 --check together
  command line: error[SC0208]: no single run shows the verdict of the check `together`
    hint: without --check it is the run of the first choices that is shown
  [64]

What cannot be done is told, and nothing is left behind.

  $ scc view $models/hexokinase.sc -o nowhere/page.html
  nowhere/page.html: error[SC0103]: cannot write: No such file or directory
  [74]
  $ scc view $models/dimer.sc --trace run.jsonl 2>&1 | head -n 1
  run.jsonl:1:1: error[SC0209]: the model has no parameter `atp_arrives`
  $ scc view $models/hexokinase.sc --schedule runs/surely.json --trace run.jsonl 2>&1 | head -n 1
  scc: --schedule and --trace do not go together: either tells which run to show
  $ scc view $models/hexokinase.sc --data --svg 1 2>&1 | head -n 1
  scc: --data and --svg do not go together
  $ scc view missing.sc
  missing.sc: error[SC0101]: cannot read: No such file or directory
  [3]
  $ ls *.html
  chain.html

A run by choices that is given up, or whose numbers become too long, is shown as far as it came: checks are decided before.

  $ cat > given_up.sc <<'EOF'
  > process p = box(1, 1, 1) mass 1 velocity (3/2, 0, 0) [nil]
  > motion p = (1/(5 - time), 0, 0)
  > check early : eventually x(p) >= 1/5 within 2
  > EOF
  $ cat > long.sc <<'EOF'
  > process p = box(1, 1, 1) mass 1 velocity (3/2, 0, 0) [nil]
  > motion p = (vx*vx - vx/3, 0, 0)
  > check early : eventually x(p) >= 1 within 2
  > EOF
  $ first() { scc view $1 --data -o - | tr -d '\n' | grep -o '"name":"first choices".*"ending":\[[^]]*\]' | grep -o '"ending":.*'; }
  $ first given_up.sc
  "ending":["the law of motion of p cannot be evaluated: it divides by zero"]
  $ first long.sc
  "ending":["it is not followed further: its numbers become too long"]
  $ scc view long.sc --bits 50 --data -o - | tr -d '\n' | grep -o '"name":"first choices".*' | grep -o '"to":' | wc -l
  6
