(* Rule Ties: which of several urgent transitions comes first, by chance. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_state_space
open Scc_verify
open Scc_test_models
module Gen = QCheck2.Gen

let cube = "shape Cube = box(1, 1, 1)\nshape Small = box(1/2, 1/2, 1/2)\n"
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

let body ?(shape = "Cube") ?(v = "0,0,0") name at behaviour =
  Printf.sprintf "process %s = %s mass 1 velocity (%s) at translate (%s) [%s]\n" name shape v at behaviour

let any = "{left, right, top, bottom, front, back}"
let site = Printf.sprintf "<a, %s>. nil" any
let key = Printf.sprintf "<~a, %s>. nil" any

(* Three run into one site at one instant, and do not touch each other. *)
let three =
  let shape = "Small" in
  body "s" "0,0,0" site ^ body ~shape "p" "-11/4,0,0" ~v:"1,0,0" key ^ body ~shape "q" "11/4,0,0" ~v:"-1,0,0" key
  ^ body ~shape "r" "0,11/4,0" ~v:"0,-1,0" key

(* Two sites with one each, far away from each other. *)
let two =
  body "s" "0,0,0" site ^ body "p" "-3,0,0" ~v:"1,0,0" key ^ body "t" "0,9,0" site ^ body "q" "-3,9,0" ~v:"1,0,0" key

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
    ("who acts comes before what is done", is ways "P = ? [ eventually bound(q, s) ]" ~chance:"1/2" ~choice:"0 to 1");
    ("then what is done", is ways "P = ? [ eventually bonds(b) = 1 ]" ~chance:"1/4" ~choice:"0 to 1");
    ("a reaction or a bond", is reacts "P = ? [ eventually bonds(a) = 1 ]" ~chance:"1/2" ~choice:"0 to 1");
    ("a mean", is three "E = ? [ if bound(p, s) then 1 else 0 at 2 ]" ~chance:"1/3" ~choice:"0 to 1");
    ("within a time", is three "P = ? [ eventually bound(p, s) within 2 ]" ~chance:"1/3" ~choice:"0 to 1");
    ("not before", is three "P = ? [ eventually bound(p, s) within 3/2 ]" ~chance:"0" ~choice:"0");
    ("below another operator", is three "P = ? [ eventually P > 0 [ eventually bound(p, s) within 0 ] ]" ~chance:"1" ~choice:"0 to 1");
    ("a weak split beside it", is beside "P = ? [ eventually bound(p, s) within 2 ]" ~chance:"0 to 1/2" ~choice:"0 to 1");
    ("stays free", is beside "P = ? [ eventually bonds(d) = 0 within 2 ]" ~chance:"0 to 1" ~choice:"0 to 1");
    ("a drain", is drains "P = ? [ not event bounce(p, q) U gone(p) ]" ~chance:"1/2" ~choice:"0 to 1");
  ]

(* {1 How surfaces are cut} *)

(* A wall of n tiles, all of which are open for a, and one for b; and what runs into it, by a or by b, beside another
   two that collide. *)
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
  let _, semantics, initial = load (drawn ^ wall 2 ~open_b:false) in
  let time s = List.hd (Result.get_ok (Network.successors semantics s)) in
  let there = Result.get_ok (Network.successors semantics (time initial).target) in
  let chances = List.map (fun (t : Transition.t) -> Rat.to_string (Option.get t.chance)) there in
  Alcotest.(check (list string)) "the other two; b; a by one feature or the other" [ "1/2"; "1/4"; "1/8"; "1/8" ]
    (List.sort String.compare chances)

(* {1 By another solver} *)

(* Probabilities by the text of the rule, from labels and states alone. *)
let whole (s : State.t) leaf = Array.to_list s.processes |> List.find (fun p -> State.has_leaf p leaf)

let who (s : State.t) (label : Transition.label) =
  let leaves =
    match label with
    | Bounce { firsts; _ } -> firsts
    | Absorb { first; absorber } -> [ first; absorber ]
    | _ -> List.concat_map (fun (b : State.bond) -> [ b.one.at; b.two.at ]) (Transition.bonds label)
  in
  List.sort_uniq Int.compare (List.map (fun l -> (whole s l).leaves.(0).leaf) leaves)

let what k (t : Transition.t) =
  match t.label with
  | Bind b | Close b ->
    let after at = (State.leaf_of (whole t.target at) at).behaviour in
    (b.name, [ b.one.at; b.two.at ], [ after b.one.at; after b.two.at ])
  | _ -> ("", [ -1 - k ], [])

let same_what (a, b, c) (a', b', c') = a = a' && b = b' && List.equal Behaviour.equal_aged c c'

let classes equal list =
  let add found x = if List.exists (equal x) found then found else x :: found in
  List.length (List.fold_left add [] list)

let by_the_text s transitions =
  let urgent = List.filter (fun (t : Transition.t) -> Transition.is_urgent t.label) transitions in
  let all = List.mapi (fun k (t : Transition.t) -> (t, who s t.label, what k t)) urgent in
  let chance (_, w, x) =
    let mine = List.filter (fun (_, w', _) -> w = w') all in
    let alike = List.filter (fun (_, _, x') -> same_what x x') mine in
    let doings = classes same_what (List.map (fun (_, _, x) -> x) mine) in
    Rat.make Z.one (Z.of_int (classes ( = ) (List.map (fun (_, w, _) -> w) all) * doings * List.length alike))
  in
  List.map (fun ((t, _, _) as one) -> (t, chance one)) all

exception Beyond

module States = Hashtbl.Make (struct
    type t = State.t * Rat.t

    let equal (s, t) (s', t') = Rat.equal t t' && State.equal s s'
    let hash (s, t) = State.hash s + Rat.hash t
  end)

(* The probability to come to the goal until a time, where nothing is free and no state of an instant recurs. *)
let probability semantics initial ~until goal =
  let known = States.create 256 and on_the_way = States.create 16 in
  let rec from s time =
    if goal s then Rat.one
    else
      match States.find_opt known (s, time) with
      | Some p -> p
      | None ->
        if States.mem on_the_way (s, time) || States.length known > 3000 then raise Beyond;
        States.add on_the_way (s, time) ();
        let p = by (Result.get_ok (Network.successors semantics s)) s time in
        States.remove on_the_way (s, time);
        States.add known (s, time) p;
        p
  and by transitions s time =
    let branches =
      match transitions with
      | ({ label = Draw _ | Lot _; _ } : Transition.t) :: _ ->
        List.map (fun (t : Transition.t) -> (t, Transition.chance t.label)) transitions
      | ts -> (
          match by_the_text s ts with
          | [] -> List.map (fun t -> (t, Rat.one)) ts
          | urgent -> urgent)
    in
    let add sum ((t : Transition.t), chance) =
      let later = Rat.add time (Transition.duration t) in
      if Rat.compare later until > 0 then sum else Rat.add sum (Rat.mul chance (from t.target later))
    in
    List.fold_left add Rat.zero branches
  in
  from initial Rat.zero

(* Some that run into each other at one or two instants, most of them into the one in the middle. *)
let faces = [ any; "{left, right}"; "{left, right, front, back}" ]

let behaviour =
  let open Gen in
  let* name = oneofl [ "a"; "~a"; "a"; "~a"; "b"; "~b" ] and* where = oneofl faces in
  let plain = match name.[0] with '~' -> String.sub name 1 1 | _ -> name in
  let+ next =
    oneofl
      [ "nil"; "nil"; Printf.sprintf "rho({<%s, %s>}). nil" plain any; Printf.sprintf "eps(1). rho({<%s, %s>}). nil" plain any;
        Printf.sprintf "<b, %s>. nil" any; Printf.sprintf "<~b, %s>. nil" any ]
  in
  Printf.sprintf "<%s, %s>. %s" name where next

let sum = Gen.(map (String.concat " + ") (list_size (frequencyl [ (3, 1); (2, 2); (1, 3) ]) behaviour))
let ways_in = [| (1, 0); (-1, 0); (0, 1); (0, -1) |]

let scene =
  let open Gen in
  let* others = 2 -- 4 and* chance = frequencyl [ (3, None); (1, Some "wait"); (1, Some "stop"); (1, Some "bounce") ] in
  let* middle = oneofl [ "fixed"; "free" ] and* drain = frequencyl [ (4, false); (1, true) ] in
  let* inner = sum in
  let* outer = list_repeat others (triple sum (oneofl [ 2; 2; 3 ]) (oneofl [ 1; 1; 2 ])) in
  let* cyclic = frequencyl [ (3, ""); (1, "bonds cyclic\n") ] in
  let* goal, count = oneofl [ ("a", 1); ("b", 1); ("a", 2); ("b", 2); ("a", 1) ] in
  let one i (b, far, speed) =
    let x, y = ways_in.(i) in
    let far = 1 + (far * speed) in
    body (Printf.sprintf "w%d" i) ~v:(Printf.sprintf "%d,%d,0" (-x * speed) (-y * speed))
      (Printf.sprintf "%d,%d,0" (x * far) (y * far)) b
  in
  let motion = match chance with
    | None -> ""
    | Some how ->
      Printf.sprintf "timestep 1 steady\nblocked %s\n" how
      ^ String.concat "" (List.init (Int.min 2 others) (fun i ->
          let x, y = ways_in.(i) in
          Printf.sprintf "motion w%d = choose { (%d,%d,0) weight 2, (0,0,0) }\n" i (-x) (-y)))
  in
  let+ top = bool in
  let text =
    cube ^ cyclic
    ^ "fixed far = Cube at translate (99, 99, 99) [<a, {left}>. nil + <b, {left}>. nil]\n"
    ^ (if middle = "fixed" then Printf.sprintf "fixed s = Cube [%s]\n" inner else body "s" "0,0,0" inner)
    ^ (if drain then "fixed drain = Cube absorb at translate (1,1,0)\n" else "")
    ^ (if top then body "top" "0,0,3" ~v:"0,0,-1" inner else "")
    ^ String.concat "" (List.mapi one outer)
    ^ motion
  in
  (text, goal, count)

type tally = {
  mutable numbers : int;
  mutable telling : int;  (** neither 0 nor 1 *)
  mutable free : int;  (** an interval without the rule *)
  mutable picks : int;
}

let tally = { numbers = 0; telling = 0; free = 0; picks = 0 }

let bonds name (s : State.t) =
  List.length (List.filter (fun (b : State.bond) -> String.equal b.name name) (State.bonds s))

let until = Rat.of_int 3

let agrees (text, goal, count) =
  let asked = Printf.sprintf "check c : P = ? [ eventually bonds(%s) >= %d within 3 ]\n" goal count in
  let _, semantics, initial = load (drawn ^ text ^ asked) in
  match probability semantics initial ~until (fun s -> bonds goal s >= count) with
  | exception Beyond -> true
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
let picks (text, _, _) =
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
let print (text, goal, count) = Printf.sprintf "%sbonds(%s) >= %d" text goal count

let random =
  [
    QCheck2.Test.make ~name:"Ties: by another solver" ~count:(150 * scale) ~print scene agrees;
    QCheck2.Test.make ~name:"Ties: random runs" ~count:(150 * scale) ~print scene picks;
  ]

let counts () =
  Printf.printf "%d numbers, of %d scenes with one between 0 and 1; %d are free without the rule; %d picks\n"
    tally.numbers tally.telling tally.free tally.picks;
  let some what expected n = if n < expected then Alcotest.failf "only %d %s" n what in
  some "numbers" 200 tally.numbers;
  some "numbers between 0 and 1" 20 tally.telling;
  some "intervals without the rule" 20 tally.free;
  some "picks" 100 tally.picks

let () =
  let by_hand () = List.iter (fun (name, test) -> print_endline name; test ()) by_hand in
  Alcotest.run "ties"
    [
      ( "by hand",
        [
          Alcotest.test_case "Ties: by hand" `Quick by_hand;
          Alcotest.test_case "Ties: how surfaces are cut" `Quick cut;
        ] );
      ("random", Scc_test_support.Property.cases random @ [ Alcotest.test_case "Ties: nothing is free" `Quick counts ]);
    ]
