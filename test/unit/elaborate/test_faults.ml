(* Every static error of elaboration: its code, and the text under its span. *)

open Scc_base
open Scc_exact
open Models
open Fault_case

let names_and_values =
  [
    case "unknown template" "SC0201" "Cub" ~says:"did you mean `Cube`" (cube ^ "process p = Cub mass 1 [nil]");
    case "unknown behaviour" "SC0201" "Opn" ~says:"did you mean `Open`"
      (cube ^ "behaviour Open = nil process p = Cube mass 1 [Opn]");
    case "unknown value" "SC0201" "m" ~says:"did you mean `n`" "param n = 1\ntimestep m";
    case "value used before it is declared" "SC0201" "n" "timestep n\nparam n = 1";
    case "unknown process in a bond" "SC0201" "q" (cube ^ "process p = Cube mass 1 [nil] \
                                                           bond <a, {p.top, q.top}>");
    case "unknown process in the network" "SC0201" "q" (cube ^ "process p = Cube mass 1 [nil] \
                                                                network p || q");
    case "unknown process in a motion" "SC0201" "q" "motion q = inertial";
    case "unknown name in a law" "SC0201" "ux" ~says:"did you mean" "motion (ux, 0, 0)";
    case "unknown function" "SC0201" "sise" ~says:"did you mean `size`"
      (cube ^ "process p = Cube mass 1 [nil] check c : always sise(p) = 1");
    case "unknown channel" "SC0201" "b" (cube ^ "process p = Cube mass 1 [<a,{top}>.nil] \
                                                 check c : always bonds(b) = 1");
    case "unknown transition" "SC0201" "bin" ~says:"did you mean `bind`" "check k : AG not event bin";
    case "unknown channel of a transition" "SC0201" "dokc" ~says:"did you mean `dock`"
      (cube ^ "process p = Cube mass 1 [<dock,{top}>.nil] check k : AG not event weak(dokc, p)");
    case "unknown process of a transition" "SC0201" "q"
      (cube ^ "process p = Cube mass 1 [<a,{top}>.nil] check k : AG not event bounce(q)");
    case "unknown template of a quantifier" "SC0201" "Cuba"
      (cube ^ "process p = Cube mass 1 [nil] check c : always forall q in Cuba: x(q) = 1");
    case "unknown template of a behaviour" "SC0201" "Cuba" (cube ^ "behaviour B on Cuba = nil");
    case "two processes with one name" "SC0202" "p" ~says:"taken"
      (cube ^ "process p = Cube mass 1 [nil] process p = Cube mass 1 at translate (9,0,0) [nil]");
    case "a process with the name of a family" "SC0202" "c"
      (cube ^ "for i in 1..2 { process c[i] = Cube mass 1 \
               at translate (4*i,0,0) [nil] }\nprocess c = Cube mass 1 at translate (99,0,0) [nil]");
    case "two templates with one name" "SC0202" "Cube" (cube ^ cube);
    case "two behaviours with one name" "SC0202" "B" "behaviour B = nil behaviour B = nil";
    case "two parameters with one name" "SC0202" "n" "param n = 1 param n = 2";
    case "two checks with one name" "SC0202" "k" "check k : always time >= 0 check k : always time >= 0";
    case "two vertices with one name" "SC0202" "a" "shape S { vertices a (0,0,0) a (1,0,0) faces f [a,a,a] }";
    case "a vertex with the name of a face" "SC0202" "a"
      "shape S { vertices a (0,0,0) b (1,0,0) c (0,1,0) faces a [a,b,c] }";
    case "two laws for one process" "SC0202" "motion p = (1,0,0)" ~says:"two laws"
      (cube ^ "process p = Cube mass 1 [nil] motion p = inertial motion p = (1,0,0)");
    case "a process twice in the network" "SC0202" "p" (cube ^ "process p = Cube mass 1 [nil] \
                                                                network p || p");
    case "unknown feature" "SC0203" "tpo" ~says:"did you mean `top`"
      (cube ^ "process p = Cube mass 1 [<a, {tpo}>. nil]");
    case "unknown vertex in a face" "SC0203" "k" "shape S { vertices a (0,0,0) b (1,0,0) c (0,1,0) \
                                                  faces f [a,b,k] }";
    case "no edge" "SC0203" "[a,g]" ~says:"not an edge" (cube ^ "process p = Cube mass 1 [<a, {[a,g]}>. nil]");
    case "a face the wrong way round" "SC0203" "[a,b,c,d]" ~says:"wrong way round"
      (cube ^ "process p = Cube mass 1 [<a, {[a,b,c,d]}>. nil]");
    case "an unknown part" "SC0203" "rigt" ~says:"has no part"
      (cube ^ corner ^ "process p = Corner [<a, {rigt.top}>. nil]");
    case "another process's feature in a behaviour" "SC0203" "q"
      (cube ^ "process p = Cube mass 1 [<a, {q.top}>. nil]");
    case "a definition with the features of one process" "SC0203" "K" ~says:"cannot be the behaviour of `q`"
      (cube
       ^ "behaviour J = <a, {p.top}>. nil process p = Cube mass 1 [J] process q = Cube mass 1 \
          at translate (9,0,0) [J + nil]"
       |> String.split_on_char 'J' |> String.concat "K");
    case "index that is not an integer" "SC0204" "1/2" (cube ^ "process c[1/2] = Cube mass 1 [nil]");
    case "loop bound that is not an integer" "SC0204" "3/2" "for i in 1..3/2 { }";
    case "a truth value for a number" "SC0205" "1 < 2" "param n = 1 < 2";
    case "a number for a truth value" "SC0205" "1" "check k : always (1 and true)";
    case "something that changes for a constant" "SC0205" "x(p)" (cube ^ "process p = Cube mass x(p) [nil]");
    case "branches of two types" "SC0205" "true" "param n = if 1 < 2 then 1 else true";
    case "a temporal formula under a comparison" "SC0205" "always time > 1"
      (cube ^ "process p = Cube mass 1 [nil] check k : always count(q in Cube: always time > 1) = 1");
    case "a temporal formula chooses a number" "SC0205" "AF time > 1" ~says:"at its instant"
      "check k : always (if AF time > 1 then 1 else 2) > 1";
    case "a number leads to" "SC0205" "time" ~says:"a formula is expected" "check k : time leads_to true";
    case "a law speaks of transitions" "SC0205" "event bounce" ~says:"law of motion"
      "motion (if event bounce then 1 else 0, 0, 0)";
    case "a constant speaks of transitions" "SC0205" "event bounce" ~says:"`event` is none"
      "param n = if event bounce then 1 else 0";
    case "a bond with a co-name" "SC0205" "~a" ~says:"the plain name of its channel: `a`"
      (cube ^ "process p = Cube mass 1 [<~a,{top}>.nil] check k : AF event bind(~a)");
    case "a value for a channel" "SC0205" "1" "check k : AF event bind(1)";
    case "an event alone" "SC0701" "not event bounce" "check k : not event bounce";
    case "processes before the channel" "SC0210" "p" ~says:"the channel comes first"
      (cube ^ "process p = Cube mass 1 [<a,{top}>.nil] check k : AF event bind(p, a)");
    case "a variable before the channel" "SC0210" "q" ~says:"the channel comes first"
      (cube ^ "process p = Cube mass 1 [<a,{top}>.nil] check k : forall q in Cube: AF event bind(q)");
    case "a length that is not declared" "SC0201" "box" ~says:"unknown name `b`"
      "process p = box (1, b, 1) mass 1 [nil]";
    case "a bounce of three" "SC0206" "event bounce(p, p, p)" ~says:"at most two processes, and is given 3"
      (cube ^ "process p = Cube mass 1 [nil] check k : AF event bounce(p, p, p)");
    case "a hit of three" "SC0206" "event hit(p, p, p)" ~says:"one body or two, or parts of them, and is given 3"
      (cube ^ "process p = Cube mass 1 [nil] check k : AF event hit(p, p, p)");
    case "a hit of nobody" "SC0206" "event hit" ~says:"is given 0"
      (cube ^ "process p = Cube mass 1 [nil] check k : AF event hit");
    case "a part of a body that has none" "SC0203" "p.low" ~says:"has no parts"
      (cube ^ "process p = Cube mass 1 [nil] check k : AF event hit(p.low)");
    case "a bind of three" "SC0206" "event bind(a, p, p, p)" ~says:"at most two"
      (cube ^ "process p = Cube mass 1 [<a,{top}>.nil] check k : AF event bind(a, p, p, p)");
    case "a family bounces" "SC0210" "c" ~says:"several bodies"
      (cube ^ "for i in 1..2 { process c[i] = Cube mass 1 at translate (4*i,0,0) [nil] } \
               check k : AF event bounce(c)");
    case "a type error in a let that nothing uses" "SC0205" "true" "let l = time + true";
    case "an unknown name in a let that nothing uses" "SC0201" "tiem" ~says:"did you mean `time`"
      "let l = possibly tiem > 1";
    case "a function without its process" "SC0201" "x" ~says:"say of which process: `x(p)`"
      (cube ^ "process p = Cube mass 1 [nil] check k : possibly x > 1");
    case "a function without its processes" "SC0201" "distance2" ~says:"`distance2(p, q)`"
      "let l = possibly distance2 > 1";
    case "the first letters of a word" "SC0201" "eventu" ~says:"did you mean `eventually`?" "let l = eventu";
    case "the first letters of a function" "SC0201" "touc" ~says:"did you mean `touching`?"
      "let l = possibly touc";
    case "a law in a let that nothing uses" "SC0201" "ux" ~says:"in a law of motion" "let l = vx + ux";
    case "a let of a let that nothing uses" "SC0205" "1" "let l = time + (1 and true) let k = l + 1";
    case "a let in a loop that nothing uses" "SC0205" "AF time > 1" ~says:"holds or not at an instant"
      (cube ^ "process p = Cube mass 1 [nil] for i in 1..2 { let l = count(q in Cube: AF time > 1) + i }");
    case "too many arguments" "SC0206" "x(p, p)" (cube ^ "process p = Cube mass 1 [nil] \
                                                          check k : always x(p, p) = 1");
    case "too few arguments" "SC0206" "bound(p)" (cube ^ "process p = Cube mass 1 [nil] \
                                                          check k : always bound(p)");
    case "division by zero" "SC0207" "1/(n-1)" "param n = 1 timestep 1/(n-1)";
    case "division by zero in a law" "SC0207" "vx/n" "param n = 0 motion (vx/n, 0, 0)";
    case "a mass that is not positive" "SC0208" "0" (cube ^ "process p = Cube mass 0 [nil]");
    case "no mass" "SC0208" "p" ~says:"has no mass" (cube ^ "process p = Cube [nil]");
    case "a step that is not positive" "SC0208" "-1" "timestep -1";
    case "a negative time bound" "SC0208" "-2" "check k : possibly time > 1 within (-2)";
    case "a negative bound of a consequence" "SC0208" "-1" "check k : true leads_to[-1, 1] time > 1";
    case "an empty bound of a consequence" "SC0208" "1/2" "check k : true leads_to[1, 1/2] time > 1";
    case "a bound that changes" "SC0201" "time" ~says:"a constant is expected" "check k : EF[<= time] time > 1";
    case "an empty time bound" "SC0208" "1" "check k : EF[2, 1] time > 1";
    case "a process for a value" "SC0210" "q" (cube ^ "process p = Cube mass 1 [nil] \
                                                       check k : always forall q in Cube: q = 1");
    case "a compound scaled" "SC0210" "Corner" (cube ^ corner ^ "process p = Corner scaled (1,2,3) mass 1 [nil]");
    case "a family for a leaf" "SC0210" "c"
      (cube ^ "for i in 1..2 { process c[i] = Cube mass 1 at translate (4*i,0,0) [nil] } \
               check k : always x(c) = 1");
    case "a bond with what is left out" "SC0210" "q.left"
      (cube
       ^ "process p = Cube mass 1 [nil] process q = Cube mass 1 at translate (2,0,0) [nil] network p \
          bond <a, {p.right, q.left}>");
    case "a declaration in a loop" "SC0210" "param k = 1" "for i in 1..2 { param k = 1 }";
    case "unused template" "SC0211" "Cube" cube;
    case "unused behaviour" "SC0211" "B" "behaviour B = nil";
    case "unused parameter" "SC0211" "n" "param n = 1";
    case "unused let" "SC0211" "l" "let l = time > 1";
    case "an attribute twice" "SC0212" "mass 2" (cube ^ "process p = Cube mass 1 mass 2 [nil]");
    case "a mass of a compound" "SC0212" "mass 2" (cube ^ corner ^ "process p = Corner mass 2 [nil]");
    case "timestep twice" "SC0212" "2" "timestep 1 timestep 2";
    case "network twice" "SC0212" "network nil" "network nil network nil"
  ]

let shape faces =
  "shape S { vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1) \
   e (-1,-1,1) f (1,-1,1) g (1,1,1) h (-1,1,1)\n"
  ^ "faces " ^ faces ^ " }"

let templates =
  [
    case "no faces" "SC0301" "vertices a (0,0,0) faces" "shape S { vertices a (0,0,0) faces }";
    case "an open solid" "SC0302" "left"
      (shape "bottom [a,d,c,b] left [a,e,h,d] right [b,c,g,f] front [a,b,f,e] back [d,h,g,c]");
    case "a face twice" "SC0303" "bottom"
      (shape "bottom [a,d,c,b] again [a,d,c,b] top [e,f,g,h] left [a,e,h,d] right [b,c,g,f] \
              front [a,b,f,e] back [d,h,g,c]");
    case "an unused vertex" "SC0304" "i" ~says:"used by no face"
      ("shape S { vertices i (0,0,0) a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1) \
        e (-1,-1,1) f (1,-1,1) g (1,1,1) h (-1,1,1)\n"
       ^ "faces bottom [a,d,c,b] top [e,f,g,h] left [a,e,h,d] right [b,c,g,f] front [a,b,f,e] back [d,h,g,c] }");
    case "faces inward" "SC0309" "Inward" ~says:"clockwise"
      (shape "bottom [b,c,d,a] top [h,g,f,e] left [d,h,e,a] right [f,g,c,b] front [e,f,b,a] back [c,g,h,d]");
    case "a singular scale" "SC0311" "Cube scaled (1,0,1)" ~says:"singular"
      (cube ^ "shape T = Cube scaled (1,0,1)");
    case "a reflection" "SC0311" "scale (1,-1,1)" ~says:"reflection"
      (cube ^ "process p = Cube mass 1 at scale (1,-1,1) [nil]");
    case "the zero quaternion" "SC0311" "rotate quaternion (0,0,0,0)"
      (cube ^ "process p = Cube mass 1 at rotate quaternion (0,0,0,0) [nil]");
    case "a matrix that is not affine" "SC0311" "matrix ((1,0,0,0),(0,1,0,0),(0,0,1,0),(1,0,0,1))"
      (cube ^ "process p = Cube mass 1 at matrix ((1,0,0,0),(0,1,0,0),(0,0,1,0),(1,0,0,1)) [nil]");
    case "an off-centre template" "SC0312" "T" ~says:"(1/4, 1/4, 1/4)"
      "shape T { vertices a (0,0,0) b (1,0,0) c (0,1,0) d (0,0,1) \
       faces x [a,c,b] y [a,b,d] z [a,d,c] w [b,c,d] }\nprocess p = T mass 1 [nil]";
    case "a mesh that cannot be read" "SC0101" "\"a.off\"" "shape T = mesh \"a.off\"";
  ]
  |> List.map (fun c ->
      if String.equal c.at "Inward" then
        let start = String.index c.text '{' + 2 in
        { c with at = String.sub c.text start (String.length c.text - start - 2) }
      else c)

let two position = Printf.sprintf "process p = Cube mass 1 [nil] process q = Cube mass 1 \
                                   at translate (%s) [nil] " position

let networks =
  [
    case "a glue that does not touch" "SC0401" "glue l.left ~ r.right" ~says:"l.right and r.left"
      (cube ^ "compound C { part l : Cube mass 1 part r : Cube mass 1 at translate (2,0,0) \
               glue l.left ~ r.right }");
    case "parts apart" "SC0401" "glue l.right ~ r.left" ~says:"do not touch"
      (cube ^ "compound C { part l : Cube mass 1 part r : Cube mass 1 at translate (3,0,0) \
               glue l.right ~ r.left }");
    case "a glue that is not the highest" "SC0402" "glue l.[b,c] ~ r.[a,d]" ~says:"l.right ~ r.left"
      (cube ^ "compound C { part l : Cube mass 1 part r : Cube mass 1 at translate (2,0,0) \
               glue l.[b,c] ~ r.[a,d] }");
    case "parts that interpenetrate" "SC0403" "r" ~says:"(1/2, 0, 0)"
      (cube ^ "compound C { part l : Cube mass 1 part r : Cube mass 1 at translate (1,0,0) \
               glue l.right ~ r.left }");
    case "bodies that interpenetrate" "SC0403" "q" ~says:"(1/2, 0, 0) is inside both" (cube ^ two "1,0,0");
    case "bodies at one place" "SC0403" "q" ~says:"(0, 0, 0) is inside both" (cube ^ two "0,0,0");
    case "a body and a wall" "SC0403" "w" (cube ^ "process p = Cube mass 1 [nil] fixed w = Cube \
                                                   at translate (0,3/2,0)");
    case "the misprinted Figure 5" "SC0404" "velocity (2,1,1)" ~says:"(2, 1, 0) and (2, 1, 1)"
      (cube
       ^ "compound C { part l : Cube mass 3 velocity (2,1,0) part r : Cube mass 3 velocity (2,1,1) \
          at translate (2,0,0) glue l.right ~ r.left }"
      );
    case "bound bodies with two velocities" "SC0404" "<a, {p.right, q.left}>"
      (cube
       ^ "process p = Cube mass 1 velocity (1,0,0) [nil] process q = Cube mass 1 \
          at translate (2,0,0) [nil] bond <a, {p.right, q.left}>");
    case "moving body bound to a wall" "SC0404" "<a, {p.right, q.left}>" ~says:"which is fixed"
      (cube
       ^ "process p = Cube mass 1 velocity (1,0,0) [nil] fixed q = Cube at translate (2,0,0) \
          bond <a, {p.right, q.left}>");
    case "parts not joined" "SC0405" "r" ~says:"no glue joins"
      (cube ^ "compound C { part l : Cube mass 1 part r : Cube mass 1 at translate (2,0,0) }");
    case "glues with a cycle" "SC0405" "glue r.left ~ l.right" ~says:"tree"
      (cube
       ^ "compound C { part l : Cube mass 1 part r : Cube mass 1 at translate (2,0,0) \
          glue l.right ~ r.left glue r.left ~ l.right }"
      );
    case "a part glued to itself" "SC0405" "glue l.left ~ l.right"
      (cube ^ "compound C { part l : Cube mass 1 glue l.left ~ l.right }");
    case "bonds with a cycle" "SC0406" "<b, {q.left, p.right}>" ~says:"cycle"
      (cube ^ two "2,0,0" ^ "bond <a, {p.right, q.left}> bond <b, {q.left, p.right}>");
    case "a bond with itself" "SC0406" "<a, {p.right, p.left}>"
      (cube ^ two "2,0,0" ^ "bond <a, {p.right, p.left}>");
    case "a bond that does not touch" "SC0401" "<a, {p.top, q.left}>" ~says:"p.right and q.left"
      (cube ^ two "2,0,0" ^ "bond <a, {p.top, q.left}>");
    case "a fixed body with a mass" "SC0407" "mass 1" (cube ^ "fixed w = Cube mass 1");
    case "a fixed body with a velocity" "SC0407" "velocity (1,0,0)" (cube ^ "fixed w = Cube \
                                                                             velocity (1,0,0)");
    case "a law for a fixed body" "SC0407" "motion w = inertial" (cube ^ "fixed w = Cube motion w = inertial");
    case "a body that moves and absorbs" "SC0409" "absorb" ~says:"only what is fixed"
      (cube ^ "process p = Cube mass 1 absorb [nil]");
    case "one that absorbs and does something" "SC0409" "eps(1). nil"
      (cube ^ "fixed w = Cube absorb [eps(1). nil]");
    case "one that is bound" "SC0409" "<a, {p.right, w.left}>"
      (cube
       ^ "process p = Cube mass 1 [nil] fixed w = Cube absorb at translate (2,0,0) bond <a, {p.right, w.left}>");
    case "a part that absorbs" "SC0409" "absorb" (cube ^ "compound C { part l : Cube mass 1 absorb }");
    case "a bare feature of a compound" "SC0408" "top" ~says:"left.top"
      (cube ^ corner ^ "process p = Corner [<a, {top}>. nil]");
    case "a bare feature in a glue" "SC0408" "right"
      (cube ^ "compound C { part l : Cube mass 1 part r : Cube mass 1 at translate (2,0,0) \
               glue right ~ r.left }");
    case "a part of a process in the network" "SC0210" "p2"
      (cube
       ^ "process r = p2 : Cube mass 1 [nil] <a, {p2.right, p3.left}> p3 : Cube mass 1 \
          at translate (2,0,0) [nil] network p2");
  ]

let behaviours_and_laws =
  [
    case "an unguarded recursion" "SC0501" "K" (cube ^ "behaviour K = nil + K process p = Cube mass 1 [K]");
    case "an unguarded recursion that nothing uses" "SC0501" "K"
      (cube ^ "behaviour K = L + nil behaviour L = eps(0). K process p = Cube mass 1 [nil]");
    case "an unknown name in a behaviour that nothing uses" "SC0201" "L"
      (cube ^ "behaviour K = eps(1). L process p = Cube mass 1 [nil]");
    case "a recursion through eps(0)" "SC0501" "K" (cube ^ "behaviour K = eps(0). K \
                                                            process p = Cube mass 1 [K]");
    case "an unguarded recursion of two" "SC0501" "J"
      (cube ^ "behaviour J = nil + K behaviour K = J process p = Cube mass 1 [K]");
    case "a negative delay" "SC0502" "-1" (cube ^ "process p = Cube mass 1 [eps(-1). nil]");
    case "a channel without features" "SC0503" "<a, {}>" (cube ^ "process p = Cube mass 1 [<a, {}>. nil]");
    case "a strong split without channels" "SC0503" "rho({}). nil"
      (cube ^ "process p = Cube mass 1 [rho({}). nil]");
    case "a behaviour on another template" "SC0504" "K" ~says:"on `Cube`"
      (cube ^ corner ^ "behaviour K on Cube = nil process p = Corner [K]");
    case "a fault in an unused behaviour" "SC0203" "tip" (cube ^ "behaviour K on Cube = <a, {tip}>. nil");
    case "a quantum that is not positive" "SC0601" "0" "motion (round(vx, 0), 0, 0)";
    case "a state predicate as a check" "SC0701" "time > 1" ~says:"always" "check k : time > 1";
    case "only, where contact binds" "SC0901" "top"
      (cube ^ "binding contact process p = Cube mass 1 [<a, {only top}>. nil]");
    case "a negative weight" "SC0601" "-1" "motion choose { (1,0,0) weight 2, (0,1,0) weight -1 }";
    case "a choice of nothing" "SC0601" "choose { (1,0,0) weight 1 - 1 }" "motion choose { (1,0,0) weight 1 - 1 }";
    case "a family of no velocity" "SC0601" "choose { for i in 1..3 if i > 3: (i,0,0) }"
      "motion choose { for i in 1..3 if i > 3: (i,0,0) }";
    case "more velocities than there may be" "SC0111" "i"
      "motion choose { for i in 1..1000, j in 1..1000, k in 1..2: (i,j,k) }";
    case "the index of a family outside of it" "SC0201" "i" "motion choose { for i in 1..3: (i,0,0), (i,0,0) }";
    case "a negative diffusion constant" "SC0601" "-1" "motion (diffuse(-1))";
    case "diffusion that depends on the state" "SC0601" "x" "motion (diffuse(x))";
    case "kicks that are too short" "SC0601" "diffuse(1, (0,0,0), 2)" ~says:"less than 6"
      "motion (diffuse(1, (0,0,0), 2))";
    case "a kick of no length" "SC0601" "0" "motion (diffuse(1, (0,0,0), 0))";
    case "diffusion of nothing" "SC0206" "diffuse()" "motion (diffuse())";
    case "diffusion within a law" "SC0205" "diffuse" ~says:"whole law" "motion (diffuse(1) + (1,0,0))";
    case "diffusion outside of a law" "SC0201" "diffuse" "let d = diffuse(1)";
  ]

(* Neighbours among the denominators have almost no common factors. *)
let many_denominators =
  let fraction i = Printf.sprintf "1/1%s%03d" (String.make 3_900 '0') i in
  let vertex i =
    Printf.sprintf "v%d (%s, %s, %s)" i (fraction (3 * i)) (fraction ((3 * i) + 1)) (fraction ((3 * i) + 2)) in
  Printf.sprintf "vertices %s faces f [v0, v1, v2]" (String.concat " " (List.init 120 vertex))

(* Each condition stands twice in the formula that an `if` between formulas is. *)
let rec conditions n =
  if n = 0 then "AF time > 1"
  else Printf.sprintf "if %s then time > %d else AF time < %d" (conditions (n - 1)) n n

let conditions_of_law n =
  let rec nested n =
    if n = 0 then "x > 1" else Printf.sprintf "if %s then y > %d else z < %d" (nested (n - 1)) n n
  in
  Printf.sprintf "if %s then 1 else 2" (nested n)

let limits =
  [
    case "too many declarations" "SC0111" "for i in 1..2000000 { }" "for i in 1..2000000 { }";
    case "too many declarations in nested loops" "SC0111" "for k in 1..1000 { }"
      "for i in 1..1000 { for j in 1..1000 { for k in 1..1000 { } } }";
    case "a constant that explodes" "SC0106" "g*g"
      "param a = 1e3900 let b = a*a let c = b*b let d = c*c let e = d*d let f = e*e let g = f*f let h = g*g \
       timestep h";
    case "a common denominator that explodes" "SC0106" many_denominators ("shape S {" ^ many_denominators ^ "}");
    case "conditions within conditions of a formula" "SC0111" (conditions 40) ~says:"terms"
      ("check k : " ^ conditions 40);
    case "conditions within conditions of a law" "SC0111" (conditions_of_law 40) ~says:"terms"
      ("motion (" ^ conditions_of_law 40 ^ ", 0, 0)");
    case "a formula that explodes" "SC0111" "always l40 > 1"
      (let step i = Printf.sprintf "let l%d = l%d + l%d\n" i (i - 1) (i - 1) in
       "let l0 = time\n" ^ String.concat "" (List.init 40 (fun i -> step (i + 1))) ^ "check k : always l40 > 1");
    case "a let that explodes and that nothing uses" "SC0111" "l40 + 1"
      (let step i = Printf.sprintf "let l%d = l%d + l%d\n" i (i - 1) (i - 1) in
       "let l0 = time\n" ^ String.concat "" (List.init 40 (fun i -> step (i + 1)))
       ^ "for i in 1..1000 { let k = l40 + 1 }");
    case "an empty model" "SC0112" "" "";
  ]

let overridden () =
  check ~overrides:[ ("m", Rat.one) ] (case "" "SC0209" "" ~says:"did you mean `n`" "param n = 1 timestep n") ()

let bad_mesh () =
  let text = "shape T = mesh \"a.off\"" in
  match elaborate ~read_file:(fun _ -> Ok "OFF\n4 4 6\n0 0 0\n") text with
  | Ok _ -> Alcotest.fail "a mesh that lies about its counts was accepted"
  | Error [ d ] ->
    Alcotest.(check string) "place" "a.off" d.span.file;
    Alcotest.(check string) "code" "SC0320" d.code
  | Error _ -> Alcotest.fail "one error was expected"

(* Only the first few of many errors of one kind at one place are told. *)
let bounded () =
  let text = cube ^ "for i in 1..1000 { process c[i] = Cube mass 1 at translate (4*i,0,0) [Opn] }" in
  match elaborate text with
  | Ok _ -> Alcotest.fail "accepted"
  | Error ds -> Alcotest.(check bool) "few" true (List.length ds <= 5)

(* Faults of different parts of a model are told in one run, in the order of the text. *)
let several () =
  let text = cube ^ "timestep 0\nprocess p = Cub mass 1 [nil]\nprocess q = Cube mass 0 [nil]\n\
                     process r = Cube mass 1 [K]\ncheck k : always x(s) = 1" in
  match elaborate text with
  | Ok _ -> Alcotest.fail "accepted"
  | Error ds ->
    let codes = List.map (fun (d : Diag.t) -> d.code) ds in
    Alcotest.(check (list string)) "codes" [ "SC0208"; "SC0201"; "SC0208"; "SC0201"; "SC0201" ] codes

let suite =
  ("faults",
   [
     ("names and values", cases names_and_values);
     ("templates", cases templates);
     ("networks", cases networks);
     ("behaviours and laws", cases behaviours_and_laws);
     ("limits", cases limits);
     ( "reports",
       [
         Alcotest.test_case "SC0209 unknown parameter" `Quick overridden;
         Alcotest.test_case "SC0320 bad mesh" `Quick bad_mesh;
         Alcotest.test_case "bounded" `Quick bounded;
         Alcotest.test_case "several in order" `Quick several;
       ] );
   ])
