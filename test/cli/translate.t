A model in another notation, and back.

  $ cat > p.sc <<'END'
  > import <solids>  // a library
  > 
  > 
  > /* what follows -- is
  >    <one> body */
  > process   p = solids.Cube(2)  mass 1   velocity (1,0,0) [ nil ] // alone
  > check far : always x(p)<9 and y(p) = 0
  > END
  $ scc translate p.sc
  import <solids> // a library
  
  /* what follows -- is
     <one> body */
  process p = solids.Cube(2) mass 1 velocity (1, 0, 0) [nil] // alone
  check far : always x(p) < 9 and y(p) = 0
  $ scc translate p.sc --to xml | tee p.xml
  <?xml version="1.0" encoding="UTF-8"?>
  <bioshape xmlns="urn:scc:bioshape:1">
    <import library="solids"/> <!-- a library -->
  
    <!-- what follows -\- is
     <one> body -->
    <process name="p">
      <leaf>
        <template name="solids.Cube(2)"/>
        <mass value="1"/>
        <velocity value="(1, 0, 0)"/>
        <behaviour>
          <nil/>
        </behaviour>
      </leaf>
    </process> <!-- alone -->
    <check name="far">always x(p) &lt; 9 and y(p) = 0</check>
  </bioshape>
  $ scc fmt p.sc > canonical.sc
  $ scc translate p.xml | diff canonical.sc -
  $ scc translate p.xml -o back.sc && diff canonical.sc back.sc
  $ scc translate p.sc -o again.xml && cmp p.xml again.xml
  $ scc translate p.sc -o p.txt --to xml && cmp p.xml p.txt

Standard input, and files of other endings, are taken for what they begin as.

  $ scc translate - < p.xml | diff canonical.sc -
  $ scc fmt p.txt | cmp - p.xml

Commands take models in XML as they take others.

  $ scc fmt --check p.xml
  $ scc check p.xml
  semantics 3
  
  far: violated
    always x(p) < 9 and y(p) = 0
    a run that violates it:
      then time passes, until time 9
      x(p) < 9 fails: x(p) = 9
      y(p) = 0 holds: y(p) = 0
      there:
        p at (9, 0, 0) [nil], velocity (1, 0, 0)
  
  explored: 1 state, 0 transitions, depth 0, model time 0; complete
  1 property: 1 violated
  [1]
  $ scc check p.xml > from-xml.out; scc check p.sc | diff - from-xml.out
  $ scc trace p.xml --steps 2 | tail -n +2 > one; scc trace p.sc --steps 2 | tail -n +2 | cmp - one
  $ scc compare p.sc p.xml | head -n 1
  equivalent modulo branching
  $ scc check ../../specs/models/bioshape/hexokinase.xml --coverage | tail -n 4
  coverage: 15 of 15 summands fired, 10 of 10 behaviours reached, 2 of 2 channels used, among 11 states
    rules: Pre 6, Weak 6, Strong 1, Sum 13, Def 13, TimeBehaviour 3, WeakSplit 6, StrongSplit 1, Bind 6, Time 3
    rules never used: Bounce, Steer
  8 properties: 7 hold, 1 violated
  $ scc check ../../specs/models/bioshape/docking.xml | tail -n 1
  3 properties: 2 hold, 1 violated

A model in the language may import one in XML, as one in XML does the other.

  $ cp ../../specs/models/bioshape/solids.xml .
  $ cat > w.sc <<'END'
  > import "solids.xml" (Wedge as W)
  > process w = W mass 1 velocity (1,0,0) [nil]
  > check moves : eventually x(w) > 1
  > END
  $ scc check w.sc | tail -n 1
  w.sc: warning[SC0703]: no event ever happens in this model: no two bodies collide, and nothing splits
    hint: `scc check --coverage` lists what never came to be
  1 property: 1 holds
  $ scc shape solids.xml:Wedge | head -n 2
  solids.xml:Wedge
  vertices: 6, edges: 9, faces: 5

What is wrong is told at its place in the document.

  $ sed 's/x(p) &lt; 9/x(q) \&lt; 9/; s/solids.Cube(2)/solids.Cub(2)/' p.xml > wrong.xml
  $ scc check wrong.xml
  wrong.xml:9:30: error[SC0201]: unknown template `solids.Cub(2)`
     |
   9 |       <template name="solids.Cub(2)"/>
     |                              ^^^
    hint: did you mean `solids.Cube`? `solids` has `Chamfered`, `Cube`, `Dodecahedron`, `Icosahedron`, `Octahedron`, `Plank`, `Room`, `Tetrahedron`, `Wedge`
  wrong.xml:17:30: error[SC0201]: unknown process `q`
      |
   17 |   <check name="far">always x(q) &lt; 9 and y(p) = 0</check>
      |                              ^
    hint: did you mean `p`?
  [3]
  $ sed 's/(1, 0, 0)/(1, 0, )/' p.xml | scc check -
  <standard input>:11:31: error[SC0110]: `)` does not fit here: expected the third of three components
      |
   11 |       <velocity value="(1, 0, )"/>
      |                               ^
  [3]
  $ sed 's/<velocity.*/<speed value="1"\/>/' p.xml | scc translate - --to sc
  <standard input>:11:7: error[SC0352]: `<speed>` does not belong here in `<leaf>`
      |
   11 |       <speed value="1"/>
      |       ^^^^^^^^^^^^^^^^^^
  <standard input>:11:7: error[SC0353]: the `<behaviour>` of this part of a process is missing
      |
   11 |       <speed value="1"/>
      |       ^^^^^^^^^^^^^^^^^^
  [3]
  $ printf 'model a\n' > not.xml; scc check not.xml
  not.xml:1:1: error[SC0350]: the first element of the document is expected here
     |
   1 | model a
     | ^
  [3]
  $ scc translate p.sc -o nowhere/p.xml
  nowhere/p.xml: error[SC0103]: cannot write: No such file or directory
  [74]

  $ cat > itself.xml <<'END'
  > <bioshape xmlns="urn:scc:bioshape:1">
  >   <import file="itself.xml"/><let name="a" value="1"/>
  > </bioshape>
  > END
  $ scc check itself.xml
  itself.xml:2:17: error[SC0216]: `itself.xml` imports itself
     |
   2 |   <import file="itself.xml"/><let name="a" value="1"/>
     |                 ^^^^^^^^^^
  [3]
