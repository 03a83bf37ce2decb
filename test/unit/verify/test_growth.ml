(* What is said of models whose exploration a bound ends: which values keep being new, each kind of them, and
   nothing where nothing of that is seen. *)

open Scc_semantics
open Scc_verify
open Scc_test_models

let cube =
  {|shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
|}

let walls = "fixed west = Cube at translate (-9,0,0)\nfixed east = Cube at translate (9,0,0)\n"

type asked = { reductions : Scc_state_space.Reduction.kind list; bounds : Bounds.t }

let few states =
  { reductions = Scc_state_space.Reduction.all; bounds = { Bounds.default with states = Default states } }

let without reduction asked =
  let others r = not (Scc_state_space.Reduction.equal reduction r) in
  { asked with reductions = List.filter others asked.reductions }

let report asked text =
  let e = Load.exactly (Load.text (cube ^ text)) in
  let semantics = Scc_engine.Standard.of_model e.model in
  match Network.initial semantics e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial ->
    let options = { Setup.default with bounds = asked.bounds; reductions = asked.reductions } in
    (e.model, (Check.run options semantics ~initial e.checks).stats)

let verdicts text =
  let e = Load.exactly (Load.text (cube ^ text)) in
  let semantics = Scc_engine.Standard.of_model e.model in
  match Network.initial semantics e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial ->
    let report = Check.run Setup.default semantics ~initial e.checks in
    List.map (fun (o : Verdict.outcome) -> Verdict.to_string o.verdict) report.outcomes

let causes asked text =
  let model, stats = report asked text in
  List.map
    (fun c ->
       let bodies = List.map (fun i -> model.leaves.(i).name) (Growth.leaves c) in
       String.concat " " (Growth.kind c :: bodies))
    stats.causes

let said what expected asked text = Alcotest.(check (list string)) what expected (causes asked text)

(* {1 Numbers} *)

let three mass_q mass_r =
  Printf.sprintf
    "%sprocess p = Cube mass 1 velocity (1,0,0) at translate (-4,0,0) [nil]\n\
     process q = Cube mass %d at translate (1/3,0,0) [nil]\n\
     process r = Cube mass %d at translate (5,0,0) [nil]\n\
     check meet : AG EF event bounce(p, q)\n" walls mass_q mass_r

let numbers () =
  said "of masses that are none of a power of two" [ "numbers q" ] (few 400) (three 2 4);
  let _, stats = report (few 400) (three 1 1) in
  Alcotest.(check bool) "equal masses exchange their velocities" true stats.complete;
  let turning rounded =
    "dynamics free_body\n" ^ rounded
    ^ "fixed west = Cube at translate (-6,0,0)\n\
       fixed east = Cube at translate (6,0,0)\n\
       process p = Cube mass 1 velocity (1,0,0) spin (0,0,1/3) at translate (-2,0,0) [nil]\n\
       process q = Cube mass 2 at translate (2,0,0) [nil]\n\
       check meet : AG EF event bounce(p, q)\n"
  in
  let bits = { (few 400) with bounds = { Bounds.default with bits = Default 10_000 } } in
  let _, stats = report bits (turning "") in
  Alcotest.(check (list string)) "of bodies that turn" [ "numbers" ] (List.map Growth.kind stats.causes);
  Alcotest.(check (list string)) "which rounding keeps short" []
    (causes (few 100) (turning "round orientation 2^-20\nround velocity 2^-20\n"))

(* {1 Steps of a law} *)

let falling = 
  "fixed floor = Cube at translate (0,0,-2)\n\
   process p = Cube mass 1 at translate (0,0,5) [nil]\n\
   motion p = (vx, vy, vz - dt)\n\
   check back : AG EF event bounce(p, floor)\n"

let steps () =
  said "begun anew by each collision" [ "steps" ] (few 30) ("timestep 1\n" ^ falling);
  said "of each process by itself" [ "steps" ] (few 30) ("timestep 1 local\n" ^ falling)

let steady () =
  let model = Load.exactly (Load.file "../../../specs/models/beat.sc") in
  let semantics = Scc_engine.Standard.of_model model.model in
  match Network.initial semantics model.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial ->
    let stats = (Check.run Setup.default semantics ~initial model.checks).stats in
    Alcotest.(check bool) "steps that keep their beat close" true (stats.complete && stats.causes = [])

(* {1 Places and times} *)

let shuttle = "process p = Cube mass 1 velocity (1,0,0) [nil]\n"
let leaver = "process q = Cube mass 1 velocity (0,0,1) at translate (0,0,20) [nil]\n"

let leaves () =
  let check = "check back : AG EF event bounce(p)\n" in
  said "one leaves the others" [ "leaves q" ] (few 200) (walls ^ shuttle ^ leaver ^ check);
  let _, stats = report (few 200) (walls ^ shuttle ^ check) in
  Alcotest.(check bool) "without it all comes back" true (stats.complete && stats.causes = []);
  let fast = "process q = Cube mass 1 velocity (0,0,2) at translate (0,0,20) [nil]\n" in
  let _, stats = report (few 200) (walls ^ shuttle ^ fast ^ check) in
  Alcotest.(check bool) "or where nobody may be as fast as it" true (stats.complete && stats.causes = []);
  said "a bound process with all of its leaves" [ "leaves q r" ] (few 200)
    (walls ^ shuttle
     ^ "process qr = q : Cube mass 1 velocity (0,0,1) at translate (0,0,20) [nil] <s, {q.right, r.left}>\n\
        r : Cube mass 1 velocity (0,0,1) at translate (2,0,20) [nil]\n" ^ check)

let drifts () =
  let clock = "behaviour Clock = eps(1). eps(1). Clock\n" in
  let pair =
    clock
    ^ "process p = Cube mass 1 velocity (1,0,0) at translate (-2,0,0) [Clock]\n\
       process q = Cube mass 1 velocity (1,0,0) at translate (0,0,20) [Clock]\n"
  in
  said "all is elsewhere" [ "drifts" ] (few 100) (pair ^ "check far : AG AF x(p) > 100\n");
  let _, stats = report (few 100) (pair ^ "check near : AG distance2(p, q) > 1\n") in
  Alcotest.(check bool) "distances do" true (stats.complete && stats.causes = []);
  said "unless it is told where it is" [ "drifts" ]
    (without Drift (without Translation (few 100)))
    (pair ^ "check near : AG EF distance2(p, q) < 1\n")

let times () =
  let check bound = Printf.sprintf "check slow : AG (EF event bounce(p, east) and x(p) < 10 + %s)\n" bound in
  said "absolute time" [ "times" ] (few 100) (walls ^ shuttle ^ check "time");
  let _, stats = report (few 100) (walls ^ shuttle ^ check "1") in
  Alcotest.(check bool) "which nobody asks for" true (stats.complete && stats.causes = []);
  said "up to a constant it says nothing" [] (few 20)
    (walls ^ shuttle ^ "check later : AG (time > 1000 => EF event bounce(p, east))\n")

(* {1 Many states of one instant} *)

let pairs behaviours n =
  behaviours
  ^ Printf.sprintf
    "for i in 1..%d { process p[i] = Cube mass 1 velocity (1,0,0) at translate (-3, 4*i, 0) [Left] }\n\
     for i in 1..%d { process q[i] = Cube mass 1 velocity (-1,0,0) at translate (3, 4*i, 0) [Right] }\n\
     check glued : AG EF bonds(s) >= %d\n" n n n

let bind = "behaviour Left on Cube = <s, {right}>. nil\nbehaviour Right on Cube = <~s, {left}>. nil\n"

let again =
  "behaviour Left on Cube = <s, {right}>. Held\nbehaviour Right on Cube = <~s, {left}>. Holds\n\
   behaviour Held on Cube = omega(s, {right}). Once\nbehaviour Holds on Cube = omega(s, {left}). Once\n\
   behaviour Once = eps(1). Once\n"

let orders () =
  said "collisions of one instant" [ "orders" ] (without Symmetry (few 3000)) (pairs bind 12);
  let _, stats = report (few 3000) (pairs bind 9) in
  Alcotest.(check bool) "all of them" true (stats.complete && stats.causes = []);
  said "few of them are not many" [] (without Symmetry (few 200)) (pairs bind 12)

let splits () =
  let bonded n =
    again
    ^ Printf.sprintf
      "for i in 1..%d { process p[i] = Cube mass 1 at translate (0, 4*i, 0) [Held] }\n\
       for i in 1..%d { process q[i] = Cube mass 1 at translate (2, 4*i, 0) [Holds] }\n\
       for i in 1..%d { bond <s, {p[i].right, q[i].left}> }\n\
       check gone : AG EF bonds(s) = 0\n" n n n
  in
  said "each put off or not" [ "splits" ] (without Symmetry (few 3000)) (bonded 12)

(* {1 Walls, and draws} *)

(* Of a room, so wide inside, with its walls. *)
let room wide =
  let far = wide + 3 in
  let plate x y z (a, b, c) =
    Printf.sprintf "fixed w%d%d%d = Cube scaled (%d,%d,%d) at translate (%d,%d,%d)\n" (x + 1) (y + 1) (z + 1) a b c
      (x * (wide + 2)) (y * (wide + 2)) (z * (wide + 2))
  in
  let thin = wide + 1 in
  let sizes x y = if x <> 0 then (1, thin, thin) else if y <> 0 then (far, 1, thin) else (far, far, 1) in
  let along x y z = plate x y z (sizes x y) in
  String.concat "" [ along 1 0 0; along (-1) 0 0; along 0 1 0; along 0 (-1) 0; along 0 0 1; along 0 0 (-1) ]

type walkers = { wide : int; count : int; ways : int; waits : bool; draw : bool; asked : int }

let walkers_text ~closed w =
  let ways = [ "(2,0,0)"; "(-2,0,0)"; "(0,2,0)"; "(0,-2,0)"; "(0,0,2)"; "(0,0,-2)" ] in
  let kicks = String.concat ", " (List.filteri (fun i _ -> i < w.ways) ways) in
  let body i =
    let velocity = if w.draw then "" else "velocity " ^ List.nth ways ((i + w.asked) mod w.ways) ^ " " in
    Printf.sprintf "process p%d = Cube mass %d %sat translate (0,%d,0) [nil]\n" i (1 + (i mod 2)) velocity
      ((4 * i) - (2 * w.count) + 2)
  in
  let check = List.nth [ "AG EF x(p0) > 3"; "possibly x(p0) = 77/5"; "AG EF event bounce(p0)" ] (w.asked mod 3) in
  (if w.waits && w.draw then "blocked wait\n" else "")
  ^ "timestep 1 steady\n"
  ^ (if closed then room w.wide else "")
  ^ String.concat "" (List.init w.count body)
  ^ (if w.draw then "motion choose { " ^ kicks ^ " }\n" else "")
  ^ "check c : " ^ check ^ "\n"

let some_walkers =
  let open QCheck2.Gen in
  let* wide = 8 -- 9 and* count = 1 -- 3 and* ways = 2 -- 6 in
  let+ waits = bool and* draw = bool and* asked = 0 -- 5 in
  { wide; count; ways; waits; draw; asked }

let kinds_of asked text =
  let _, stats = report asked text in
  List.map Growth.kind stats.causes

(* Within walls nothing leaves, nor does all of it drift. *)
let in_rooms =
  QCheck2.Test.make ~name:"in a room no wall is named" ~count:20 ~print:(walkers_text ~closed:true) some_walkers
    (fun w ->
       let kinds = kinds_of (few 300) (walkers_text ~closed:true w) in
       not (List.mem "leaves" kinds || List.mem "drifts" kinds))

(* What is named in open space is not where the room has been built around it. *)
let in_the_open =
  QCheck2.Test.make ~name:"in the open a wall helps" ~count:10 ~print:(walkers_text ~closed:false) some_walkers
    (fun w ->
       let named kinds = List.mem "leaves" kinds || List.mem "drifts" kinds in
       (not (named (kinds_of (few 300) (walkers_text ~closed:false w))))
       || not (named (kinds_of (few 300) (walkers_text ~closed:true w))))

(* Draws are named where many bodies draw at once, and where all that is explored is of the time 0. *)
let draws () =
  let many count = { wide = 20; count; ways = 4; waits = true; draw = true; asked = 0 } in
  let named count = List.mem "draws" (kinds_of (few 2000) (walkers_text ~closed:true (many count))) in
  let names = List.map (fun n -> (n, named n)) [ 1; 2; 5; 6; 8 ] in
  Alcotest.(check (list (pair int bool))) "by how many bodies draw"
    [ (1, false); (2, false); (5, true); (6, true); (8, true) ] names

(* {1 Nothing} *)

let nothing () =
  let depth = { (few 100) with bounds = { Bounds.default with depth = Given 20 } } in
  let open_end = walls ^ shuttle ^ leaver ^ "check back : AG EF event bounce(p)\n" in
  said "of a depth that was asked for" [] depth open_end;
  said "of a time that was asked for" []
    { depth with bounds = { Bounds.default with time = Given (Scc_exact.Rat.of_int 50) } }
    open_end;
  let same = causes (few 200) open_end in
  Alcotest.(check (list string)) "the same each time" same (causes (few 200) open_end)

let words () =
  let model, stats = report (few 200) (walls ^ shuttle ^ leaver ^ "check back : AG EF event bounce(p)\n") in
  match stats.causes with
  | [ cause ] ->
    Alcotest.(check string) "what was seen"
      "q leaves all others, while these come back to where they were: at the end of the deepest run it is 1413.02 \
       from the nearest, and was 1077.02 not long before"
      (Growth.to_string model cause);
    Alcotest.(check string) "what helps"
      "put a `fixed` wall in its way, or one that says `absorb`; or give the check a bound: `within t`"
      (Growth.cure model cause)
  | _ -> Alcotest.fail "one cause"

(* {1 The guide} *)

(* The fenced blocks of a text that have a word behind the fence, with it. *)
let blocks text =
  let fence = "```" in
  let rec from open_ found = function
    | [] -> List.rev found
    | line :: rest -> (
        let n = String.length line in
        let is_fence = n >= 3 && String.equal (String.sub line 0 3) fence in
        match open_ with
        | None when is_fence -> from (Some (String.sub line 3 (n - 3), [])) found rest
        | None -> from None found rest
        | Some (word, lines) when is_fence -> from None ((word, String.concat "\n" (List.rev lines)) :: found) rest
        | Some (word, lines) -> from (Some (word, line :: lines)) found rest)
  in
  from None [] (String.split_on_char '\n' text) |> List.filter (fun (word, _) -> word <> "")

let before = "before "

(* Each model of the chapter blows up for the reason that its block names, and the one after it closes. *)
let guide () =
  let blocks = blocks (Load.read "../../../specs/guide.md") in
  let walls = List.assoc "walls" blocks in
  let kinds = List.filter (fun (word, _) -> String.length word > String.length before) blocks in
  let kind word = String.sub word (String.length before) (String.length word - String.length before) in
  Alcotest.(check (list string)) "each kind of cause, and a cure"
    [ "leaves"; "drifts"; "times"; "numbers"; "steps"; "orders"; "splits"; "draws" ]
    (List.map (fun (word, _) -> kind word) kinds);
  let rec cured = function
    | (word, _) :: (("after", _) :: _ as rest) when word <> "after" -> cured rest
    | ("after", _) :: rest -> cured rest
    | (word, _) :: _ -> Alcotest.failf "no cure follows: %s" word
    | [] -> ()
  in
  cured (List.filter (fun (word, _) -> word <> "walls") blocks);
  let states = function "steps" -> 40 | "orders" | "splits" -> 2_000 | _ -> 300 in
  let try_ (word, text) =
    let text = walls ^ "\n" ^ text ^ "\n" in
    match word with
    | "walls" -> ()
    | "after" ->
      let e = Load.exactly (Load.text (cube ^ text)) in
      let _, stats = report (few 2_000) text in
      Alcotest.(check bool) ("this closes: " ^ text) true (stats.complete && stats.causes = []);
      let verdicts = verdicts text in
      Alcotest.(check (list string)) text (List.map (fun _ -> "holds (exhaustive)") e.checks) verdicts
    | _ ->
      (match causes (few (states (kind word))) text with
       | first :: _ ->
         Alcotest.(check string) text (kind word) (List.hd (String.split_on_char ' ' first))
       | [] -> Alcotest.failf "nothing is said of: %s" text)
  in
  List.iter try_ blocks

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("growth",
   [
     ( "causes",
       [
         case "numbers" numbers;
         case "steps of a law" steps;
         case "steps that keep their beat" steady;
         case "one that leaves" leaves;
         case "drift" drifts;
         case "absolute time" times;
         case "orders of one instant" orders;
         case "weak splits" splits;
         case "nothing to say" nothing;
         case "words" words;
         case "many draws" draws;
       ] );
     ("walls", Scc_test_support.Property.cases [ in_rooms; in_the_open ]);
     ("the guide", [ case "its models before and after" guide ]);
   ])
