(* Formulas of timed CTL over zones against the ordinary checker: at points of the parameters both give the same
   verdict. Where bonds are released at any time, the runs on a grid of instants are some of all: what one of these
   shows holds. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_polyhedra
open Scc_verify
open Scc_zones
module Gen = QCheck2.Gen

type case = { scene : Scene.t; formulas : Property.temporal list; seed : int }

let anytime = { Property.low = Rat.zero; high = None }

(* What ends with some time: nothing after it counts. *)
let settled leaves ~quantifier ~below =
  let open Gen in
  let prop = Predicates.generate leaves ~timed:false 1 in
  let compare op n = Property.Compare (op, Quantity Time, Const (Rat.of_int n)) in
  let time ops = map2 compare (oneofl ops) (0 -- 4) in
  let state p = map (fun p -> Property.State p) p in
  let late = state (time Law.[ Gt; Ge ]) and early = state (time Law.[ Lt; Le; Eq ]) in
  let both f g = map2 (fun f g -> Property.Temporal_and [ f; g ]) f g in
  let either f g = map2 (fun f g -> Property.Temporal_or [ f; g ]) f g in
  let finally f = map2 (fun q f -> Property.Finally (q, anytime, f)) quantifier f in
  let globally f = map2 (fun q f -> Property.Globally (q, anytime, f)) quantifier f in
  let until f g = map3 (fun q f g -> Property.Until (q, anytime, f, g)) quantifier f g in
  let one goal =
    frequency
      [
        (2, finally (both goal early)); (2, globally (either goal late));
        (1, until goal (both (state prop) early)); (1, until early goal); (1, until goal late); (1, finally late);
      ]
  in
  frequency [ (4, one below); (1, finally (both early (one below))) ]

(* Where time is asked about, each operator has a bound and stands by itself, or it has a goal that ends with some
   time, since all that is later is left out; the events that are next may be however late. *)
let formula leaves ~timed ~quantifiers =
  let open Gen in
  let prop = Predicates.generate leaves ~timed 1 in
  let quantifier = oneofl quantifiers in
  let bound =
    if timed then map (fun n -> { Property.low = Rat.zero; high = Some (Rat.of_int n) }) (0 -- 5) else pure anytime
  in
  let next below = map2 (fun q f -> Property.Next (q, f)) quantifier below in
  let rec temporal depth =
    let state = map (fun p -> Property.State p) prop in
    let below =
      if depth > 0 then either (depth - 1)
      else if timed then frequency [ (7, state); (2, next state); (1, next (next state)) ]
      else state
    in
    frequency
      [
        (2, map3 (fun q b f -> Property.Finally (q, b, f)) quantifier bound below);
        (2, map3 (fun q b f -> Property.Globally (q, b, f)) quantifier bound below);
        (2, map3 (fun q b (f, g) -> Property.Until (q, b, f, g)) quantifier bound (pair below below));
        ((if timed then 3 else 0), settled leaves ~quantifier ~below);
        ((if timed then 0 else 3), next below);
        ((if List.length quantifiers > 1 then 1 else 0),
         map (fun f -> Property.Temporal_not f) (delay (fun () -> temporal depth)));
      ]
  and either depth = frequency [ (1, map (fun p -> Property.State p) prop); (2, temporal depth) ] in
  if timed then temporal 0 else oneof [ temporal 0; temporal 1 ]

let generate =
  let open Gen in
  let* scene = Scene.generate in
  let scene = { scene with splits = Grid } in
  let leaves = List.length scene.bodies in
  let quantifiers = [ Property.All; Exists ] in
  let+ formulas = list_repeat 5 (formula leaves ~timed:scene.timed ~quantifiers) and+ seed = 0 -- 1_000_000 in
  { scene; formulas; seed }

(* Formulas that ask for some run in which the first two bodies come apart. *)
let parting leaves ~timed =
  let open Gen in
  let bound = Property.Fact (Bound (0, 1)) in
  let apart = Property.Not bound in
  let state p = Property.State p in
  let bounds = { Property.low = Rat.zero; high = None } in
  let* p = Predicates.generate leaves ~timed:false 1 in
  let until = Property.Until (Exists, bounds, state (Or [ bound; p ]), state (And [ apart; p ])) in
  let for_ever = Property.Globally (Exists, bounds, state apart) in
  let or_else = Property.Globally (Exists, bounds, state (Or [ apart; p ])) in
  let untimed =
    [ until; Finally (Exists, bounds, for_ever); Until (Exists, bounds, state bound, for_ever);
      Finally (Exists, bounds, or_else) ]
  in
  let start = Property.Compare (Le, Quantity Time, Const Rat.zero) in
  let early = { Property.low = Rat.zero; high = Some Rat.one } in
  let at_once = Property.Until (Exists, early, state (And [ bound; start ]), state apart) in
  oneofl (if timed then [ until; at_once ] else untimed)

(* Formulas that ask for some run, of two bodies that may come apart at any time, and perhaps others. *)
let generate_any =
  let open Gen in
  let* scene = Scene.generate_bound in
  let leaves = List.length scene.bodies in
  let some_run = formula leaves ~timed:scene.timed ~quantifiers:[ Property.Exists ] in
  let+ formulas = list_repeat 5 (oneof [ parting leaves ~timed:scene.timed; some_run ])
  and+ seed = 0 -- 1_000_000 in
  { scene; formulas; seed }

let check i formula = { Property.name = string_of_int i; span = Scc_base.Span.none; text = ""; asked = Whether;
                        formula }
let options = { Setup.default with bounds = { Bounds.default with states = Given 150; depth = Given 60 } }
let many = { Setup.default with bounds = { Bounds.default with states = Given 600; depth = Given 120 } }
let compared = ref 0
let shown = ref 0
let holding = ref 0
let undecided = ref 0
let branching = ref 0
let next = ref 0

let rec mentions_next = function
  | Property.Next _ -> true
  | f -> List.exists mentions_next (Parts.of_temporal f)

let is_search f = Plan.is_search (Plan.of_formula f)

let grid (s : Scene.t) : Model.splits =
  match s.splits with Grid -> Every Rat.one | Any -> Every (Rat.make Z.one (Z.of_int 2))

let at_point case standard report values =
  let s = case.scene in
  let ordinary = { (Scene.model_at s ~timed:s.timed values) with splits = grid s } in
  let semantics = Semantics.with_model standard ordinary in
  let initial =
    match Network.initial semantics (Scene.declared_at s values) with
    | Ok initial -> initial
    | Error _ -> failwith "no initial state"
  in
  let ordinary = Check.run many semantics ~initial (List.mapi check case.formulas) in
  let fail values (o : Verdict.outcome) does =
    QCheck2.Test.fail_reportf "at %s formula %s %s, but not over zones (seed %d)"
      (String.concat ", " (List.map Rat.to_string (Array.to_list values)))
      o.check.name does case.seed
  in
  let one (o : Verdict.outcome) (w : Scc_regions.Where.t) =
    let mem u = Union.mem u values in
    let known = if mem w.holds then Some true else if mem w.fails then Some false else None in
    let verdict =
      match o.verdict with Holds { bounds = []; _ } -> Some true | Violated _ -> Some false | _ -> None
    in
    match (verdict, known) with
    | Some true, Some b when s.splits = Any ->
      incr shown;
      if not b then fail values o "holds on a grid"
    | _ when s.splits = Any -> ()
    | Some a, Some b ->
      incr compared;
      if a then incr holding;
      if not (is_search o.check.formula) then incr branching;
      if mentions_next o.check.formula then incr next;
      if a <> b then fail values o (if a then "holds" else "is violated")
    | _ -> incr undecided
  in
  List.iter2 one ordinary.outcomes report

let points (m : Model.t) random (report : Scc_regions.Where.t list) =
  let of_piece p = List.filter_map (fun f -> f p) [ Polyhedron.corner; Polyhedron.interior_point ] in
  let of_set u = List.concat_map of_piece (Union.pieces u) in
  let all = List.concat_map (fun (w : Scc_regions.Where.t) -> of_set w.holds @ of_set w.fails) report in
  let all = Array.of_list (List.filter (Polyhedron.mem (Ranges.box m.ranges)) all) in
  if all = [||] then [] else List.init 4 (fun _ -> all.(Random.State.int random (Array.length all)))

let agrees_together case =
  let s = case.scene in
  let m = Scene.model s in
  let standard = Scc_engine.Standard.of_model m in
  let u = Scene.uncertain s in
  let middle = Option.get (Polyhedron.interior_point (Ranges.box m.ranges)) in
  let declared = Scene.declared s middle in
  match Zone_check.run options standard u ~declared ~exactly:true ~premises:[] (List.mapi check case.formulas) with
  | Error _ -> true
  | Ok report ->
    List.iter (at_point case standard report.where) (points m (Random.State.make [| case.seed |]) report.where);
    true

(* Each by itself as well: the time up to which zones are explored is the latest of those that are asked together.
*)
let agrees case =
  agrees_together case && List.for_all (fun f -> agrees_together { case with formulas = [ f ] }) case.formulas

let print case =
  String.concat "\n" (Scene.print case.scene :: List.mapi (fun i _ -> Printf.sprintf "formula %d" i) case.formulas)

let law = QCheck2.Test.make ~name:"formulas" ~count:75 ~print generate agrees
let law_any = QCheck2.Test.make ~name:"runs on a grid" ~count:60 ~print generate_any agrees

let enough () =
  Printf.printf "%d formulas that a run on a grid shows\n" !shown;
  Alcotest.(check bool) "many runs" true (!shown > 200);
  Printf.printf "%d verdicts, %d of them hold, %d of branching formulas, %d with X; %d not known\n" !compared
    !holding !branching !next !undecided;
  Alcotest.(check bool) "many verdicts" true (!compared > 500 && !branching > 100 && !next > 100)

let () =
  Alcotest.run "formulas over zones"
    [
      ("random",
       Scc_test_support.Property.cases [ law; law_any ] @ [ Alcotest.test_case "enough" `Quick enough ]);
    ]
