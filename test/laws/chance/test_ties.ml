(* Rule Ties: which of several urgent transitions comes first, by chance. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_state_space
open Scc_verify
open Scc_test_models
open Tied_scenes

let drawn = "collisions drawn\n"
let free = "collisions in_turn\n"

let load text =
  let e = Load.exactly (Load.text text) in
  let semantics = Scc_engine.Standard.of_model e.model in
  (e, semantics, Result.get_ok (Network.initial semantics e.declared))

let check ?(states = 20_000) text reductions =
  let e, semantics, initial = load text in
  let bounds = { Bounds.default with states = Default states } in
  let report = Check.run { Setup.default with bounds; reductions } semantics ~initial e.checks in
  (List.hd report.outcomes).verdict

let exact (a : Scc_chance.Answer.t) = match a with Exact x -> Some x | _ -> None

let range : Verdict.t -> (Rat.t * Rat.t) option = function
  | Measured { reasons = []; values = (_, m) :: rest; _ } ->
    let last = List.fold_left (fun _ (_, m) -> m) m rest in
    Option.bind (exact m.least) (fun low -> Option.map (fun high -> (low, high)) (exact last.most))
  | _ -> None

let told v =
  match range v with
  | Some (low, high) when Rat.equal low high -> Rat.to_string low
  | Some (low, high) -> Rat.to_string low ^ " to " ^ Rat.to_string high
  | None -> "no number"

(* {1 By hand} *)

(* Three run into one site at one instant, and do not touch each other. *)
let three =
  let shape = "Small" in
  body "s" "0,0,0" site ^ body ~shape "p" "-11/4,0,0" ~v:"1,0,0" key ^ body ~shape "q" "11/4,0,0" ~v:"-1,0,0" key
  ^ body ~shape "r" "0,11/4,0" ~v:"0,-1,0" key

(* Two sites with one each, far away from each other. *)
let two =
  body "s" "0,0,0" site ^ body "p" "-3,0,0" ~v:"1,0,0" key
  ^ body "t" "0,9,0" site ^ body "q" "-3,9,0" ~v:"1,0,0" key

(* One of two that run into a site has two ways to bind, and the other one has one. *)
let ways =
  body "s" "0,0,0" (Printf.sprintf "<a, %s>. nil + <b, %s>. nil" any any)
  ^ body "p" "-3,0,0" ~v:"1,0,0" (Printf.sprintf "<~a, %s>. nil + <~b, %s>. nil" any any)
  ^ body "q" "3,0,0" ~v:"-1,0,0" key

(* A bond of three may react as soon as r runs into its one end, which may bind instead. *)
let reacts =
  let left = Printf.sprintf "eps(2). rho({<d, %s>}). nil" any in
  body "p" "0,0,0" left
  ^ body "q" "1,0,0" (Printf.sprintf "%s + eps(2). <a, {right}>. nil" left)
  ^ "bond <d, {p.right, q.left}>\n" ^ body "r" "4,0,0" ~v:"-1,0,0" "<~a, {left}>. nil"

(* A ball runs into a drain and into another ball at one instant. *)
let drains =
  "fixed drain = Cube absorb at translate (1,0,0)\n" ^ body "p" "-2,0,0" ~v:"1,0,0" "nil"
  ^ body "q" "0,-3,0" ~v:"0,1,0" "nil" ^ body "o" "0,1,0" "nil"

(* As [three], and one of them may let go of another body at that instant: a choice that stays free. *)
let beside =
  "split_step 2\n" ^ body "s" "0,0,0" site
  ^ body "p" "-3,0,0" ~v:"1,0,0" (Printf.sprintf "%s + omega(d, %s). nil" key any)
  ^ body "w" "-4,0,0" ~v:"1,0,0" (Printf.sprintf "omega(d, %s). nil" any)
  ^ "bond <d, {w.right, p.left}>\n" ^ body "q" "3,0,0" ~v:"-1,0,0" key

let first p q = Printf.sprintf "P = ? [ not bound(%s) U bound(%s) ]" q p

let all_kinds = [ ("with all reductions", Reduction.all); ("with none", []); ("with jumps", [ Reduction.Jump ]) ]

let is scene formula ~chance ~choice () =
  let text settings = cube ^ settings ^ scene ^ "check c : " ^ formula in
  let each (name, kinds) =
    Alcotest.(check string) ("drawn, " ^ name) chance (told (check (text drawn) kinds));
    Alcotest.(check string) ("in turn, " ^ name) choice (told (check (text free) kinds))
  in
  List.iter each all_kinds

let by_hand =
  [
    ("three into one site", is three "P = ? [ eventually bound(p, s) ]" ~chance:"1/3" ~choice:"0 to 1");
    ("one of them", is three "P = ? [ eventually bonds(a) = 1 ]" ~chance:"1" ~choice:"1");
    ("two into two sites", is two (first "p, s" "q, t") ~chance:"1/2" ~choice:"0 to 1");
    ("both in the end", is two "P = ? [ eventually bonds(a) = 2 ]" ~chance:"1" ~choice:"1");
    ("who acts comes first", is ways "P = ? [ eventually bound(q, s) ]" ~chance:"1/2" ~choice:"0 to 1");
    ("then what is done", is ways "P = ? [ eventually bonds(b) = 1 ]" ~chance:"1/4" ~choice:"0 to 1");
    ("a reaction or a bond", is reacts "P = ? [ eventually bonds(a) = 1 ]" ~chance:"1/2" ~choice:"0 to 1");
    ("a mean", is three "E = ? [ if bound(p, s) then 1 else 0 at 2 ]" ~chance:"1/3" ~choice:"0 to 1");
    ("within a time", is three "P = ? [ eventually bound(p, s) within 2 ]" ~chance:"1/3" ~choice:"0 to 1");
    ("not before", is three "P = ? [ eventually bound(p, s) within 3/2 ]" ~chance:"0" ~choice:"0");
    ("below another operator",
     is three "P = ? [ eventually P > 0 [ eventually bound(p, s) within 0 ] ]" ~chance:"1" ~choice:"0 to 1");
    ("a weak split beside it",
     is beside "P = ? [ eventually bound(p, s) within 2 ]" ~chance:"0 to 1/2" ~choice:"0 to 1");
    ("stays free", is beside "P = ? [ eventually bonds(d) = 0 within 2 ]" ~chance:"0 to 1" ~choice:"0 to 1");
    ("a drain", is drains "P = ? [ not event bounce(p, q) U gone(p) ]" ~chance:"1/2" ~choice:"0 to 1");
  ]

(* {1 How surfaces are cut} *)

(* A wall of n tiles, all of which are open for a, and one or all for b. A key runs into it, which binds by a or b.
   At the same instant another two collide. *)
let wall n ~open_b =
  let tile i = Printf.sprintf "part t%d : Tile mass 1 at translate (0, %d/%d, 0)" i (4 * i) n in
  let glue i = Printf.sprintf "glue t%d.back ~ t%d.front" i (i + 1) in
  let face i = Printf.sprintf "t%d.left" i in
  let faces = String.concat ", " (List.init n face) in
  Printf.sprintf "shape Tile = box(1, 4/%d, 1)\ncompound Wall {\n%s\n%s\n}\n" n
    (String.concat "\n" (List.init n tile)) (String.concat "\n" (List.init (n - 1) glue))
  ^ Printf.sprintf "behaviour W on Wall = <a, {%s}>. nil + <b, {%s}>. nil\n" faces
    (if open_b then faces else face 0)
  ^ "shape Key = box(1, 4, 1)\nbehaviour K on Key = <~a, {right}>. nil + <~b, {right}>. nil\n"
  ^ Printf.sprintf "fixed wall = Wall at translate (0, 2/%d, 0) [W]\n" n
  ^ "process k = Key mass 1 velocity (1,0,0) at translate (-3, 2, 0) [K]\n"
  ^ "process x = Key mass 1 velocity (1,0,0) at translate (-3, 20, 0) [<c, {right}>. nil]\n"
  ^ "process y = Key mass 1 at translate (0, 20, 0) [<~c, {left}>. nil]\n"

(* The chances, sorted, of what is possible after so many first transitions. *)
let chances text ~after =
  let _, semantics, initial = load (drawn ^ text) in
  let rec go n s =
    let all = Result.get_ok (Network.successors semantics s) in
    if n = 0 then all else go (n - 1) (List.hd all).target
  in
  let told (t : Transition.t) = Rat.to_string (Option.get t.chance) in
  List.sort String.compare (List.map told (go after initial))

let cut () =
  let value n ~open_b formula = told (check (drawn ^ wall n ~open_b ^ "check c : " ^ formula) Reduction.all) in
  let each n open_b =
    let name what = Printf.sprintf "%s, %d tiles" what n in
    Alcotest.(check string) (name "which bond") "1/2" (value n ~open_b "P = ? [ eventually bonds(a) = 1 ]");
    Alcotest.(check string) (name "which two") "1/2"
      (value n ~open_b "P = ? [ not bound(x, y) U bound(k, wall) ]");
    Alcotest.(check string) (name "the other bond") "1/2"
      (value n ~open_b "P = ? [ eventually bound(k, wall) and bonds(b) = 1 ]")
  in
  List.iter (fun n -> List.iter (each n) [ true; false ]) [ 1; 2; 3 ];
  (* The features themselves are as likely as each other. *)
  Alcotest.(check (list string)) "the other two; b; a by one feature or the other" [ "1/2"; "1/4"; "1/8"; "1/8" ]
    (chances (wall 2 ~open_b:false) ~after:1)

(* A chain of four around a square, which may react in two places, or close by either of two edges. *)
let square =
  let corner name at behaviour = body name at behaviour and bond name = Printf.sprintf "bond <%s, {%s}>\n" name in
  "bonds cyclic\n"
  ^ corner "p" "0,0,0" "rho({<x, {right}>}). nil + <c, {left, right}>. nil"
  ^ corner "q" "1,0,0" "rho({<x, {left}>}). nil" ^ corner "r" "1,1,0" "rho({<y, {left}>}). nil"
  ^ corner "s" "0,1,0" "rho({<y, {right}>}). nil + <~c, {front}>. nil"
  ^ bond "x" "p.right, q.left" ^ bond "d" "q.back, r.front" ^ bond "y" "r.left, s.right"

let closes () =
  Alcotest.(check (list string)) "what one process does: two reactions, and a bond by two edges"
    [ "1/3"; "1/3"; "1/6"; "1/6" ]
    (chances (cube ^ square) ~after:0)

(* {1 By another solver} *)

type tally = {
  mutable numbers : int;
  mutable telling : int;  (** neither 0 nor 1 *)
  mutable free : int;  (** an interval without the rule *)
  mutable picks : int;
}

let tally = { numbers = 0; telling = 0; free = 0; picks = 0 }

let met (m : Model.t) goal (s : State.t) =
  let name i = m.leaves.(i).name in
  let is_met =
    match goal with
    | Bonds (wanted, _) -> fun (b : State.bond) -> String.equal b.name wanted
    | Bound leaf ->
      fun b -> List.sort String.compare [ name b.one.at; name b.two.at ] = List.sort String.compare [ leaf; "s" ]
  in
  List.length (List.filter is_met (State.bonds s)) >= match goal with Bonds (_, count) -> count | Bound _ -> 1

let until = Rat.of_int 3

let agrees (text, goal) =
  let asked = Printf.sprintf "check c : P = ? [ eventually %s within 3 ]\n" (formula goal) in
  let _, semantics, initial = load (drawn ^ text ^ asked) in
  match By_the_text.probability semantics initial ~until (met (Semantics.model semantics) goal) with
  | exception By_the_text.Beyond -> true
  | expected ->
    let one (name, kinds) =
      match range (check ~states:4000 (drawn ^ text ^ asked) kinds) with
      | None -> ()
      | Some (low, high) ->
        tally.numbers <- tally.numbers + 1;
        if not (Rat.equal low high) then QCheck2.Test.fail_reportf "%s: something is free" name;
        if not (Rat.equal low expected) then
          QCheck2.Test.fail_reportf "%s: %s, and not %s" name (Rat.to_string low) (Rat.to_string expected)
    in
    List.iter one all_kinds;
    if Rat.sign expected > 0 && Rat.compare expected Rat.one < 0 then tally.telling <- tally.telling + 1;
    (match range (check ~states:4000 (free ^ text ^ asked) Reduction.all) with
     | None -> ()
     | Some (low, high) ->
       if not (Rat.equal low high) then tally.free <- tally.free + 1;
       if Rat.compare low expected > 0 || Rat.compare high expected < 0 then
         QCheck2.Test.fail_report "it is beyond what choices can do");
    true

(* {1 Random runs} *)

exception More of (int -> Rat.t)
exception Again

(* The probabilities with which a pick returns each index. An index that is drawn again is left out, and the others
   are scaled: that is what drawing again amounts to. *)
let distribution (pick : Ties.source -> int) =
  let rec go script chance =
    let left = ref script and drawn = ref false in
    let next n odds =
      match !left with
      | k :: rest ->
        left := rest;
        k
      | [] -> raise (More (fun k -> if k < n then odds k else Rat.zero))
    in
    let below n =
      if !drawn then raise Again;
      drawn := true;
      next n (fun _ -> Rat.make Z.one (Z.of_int n))
    in
    let by_chance chances = next (List.length chances) (List.nth chances) in
    match pick { below; by_chance } with
    | i -> [ (i, chance) ]
    | exception Again -> []
    | exception More odds ->
      let rec each k =
        let p = odds k in
        if Rat.sign p = 0 then [] else go (script @ [ k ]) (Rat.mul chance p) @ each (k + 1)
      in
      each 0
  in
  let found = go [] Rat.one in
  let total = List.fold_left (fun sum (_, p) -> Rat.add sum p) Rat.zero found in
  List.map (fun (i, p) -> (i, Rat.div p total)) found

(* At each state of a run that takes the last transition: what is picked is as likely as the rule says. *)
let picks (text, _) =
  let _, semantics, initial = load (drawn ^ text) in
  let rec follow fuel s =
    if fuel > 0 then
      match Result.get_ok (Network.successors semantics s) with
      | [] -> ()
      | transitions ->
        let labels = Result.get_ok (Scc_engine.Run.labels (Scc_engine.Run.resume semantics s)) in
        let chances = List.mapi (fun i (t : Transition.t) -> (i, t.chance)) transitions in
        let is_draw = Transition.is_drawn (List.hd transitions).label in
        (match labels.tie with
         | None ->
           if (not is_draw) && List.exists (fun (_, c) -> Option.is_some c) chances then
             QCheck2.Test.fail_report "chance decides nothing in a run"
         | Some tie ->
           tally.picks <- tally.picks + 1;
           let picked = distribution tie.pick in
           let same (i, chance) =
             match (chance, List.assoc_opt i picked) with
             | Some p, Some q -> Rat.equal p q && not (List.mem i tie.others)
             | None, None -> List.mem i tie.others
             | _ -> false
           in
           if not (List.for_all same chances) then QCheck2.Test.fail_report "other probabilities");
        follow (fuel - 1) (List.nth transitions (List.length transitions - 1)).target
  in
  follow 12 initial;
  true

let scale = match Sys.getenv_opt "TIES" with Some n -> int_of_string n | None -> 1
let print (text, goal) = text ^ formula goal

let random =
  [
    QCheck2.Test.make ~name:"Ties: by another solver" ~count:(100 * scale) ~print scene agrees;
    QCheck2.Test.make ~name:"Ties: random runs" ~count:(150 * scale) ~print scene picks;
  ]

let counts () =
  Printf.printf "%d numbers, of %d scenes with one between 0 and 1; %d are free without the rule; %d picks\n"
    tally.numbers tally.telling tally.free tally.picks;
  let some what expected n = if n < expected then Alcotest.failf "only %d %s" n what in
  some "numbers" 150 tally.numbers;
  some "numbers between 0 and 1" 20 tally.telling;
  some "intervals without the rule" 15 tally.free;
  some "picks" 100 tally.picks

let () =
  let by_hand () = List.iter (fun (name, test) -> print_endline name; test ()) by_hand in
  Alcotest.run "ties"
    [
      ( "by hand",
        [
          Alcotest.test_case "Ties: by hand" `Quick by_hand;
          Alcotest.test_case "Ties: how surfaces are cut" `Quick cut;
          Alcotest.test_case "Ties: what one process does" `Quick closes;
        ] );
      ( "random",
        Scc_test_support.Property.cases random @ [ Alcotest.test_case "Ties: nothing is free" `Quick counts ] );
    ]
