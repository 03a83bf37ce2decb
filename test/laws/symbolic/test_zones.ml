(* Zones against the ordinary rules at points of the parameters: all that the ordinary rules reach is in some zone;
   to each zone leads a run, which the ordinary rules follow; and searches find predicates for just those values of
   the parameters for which some ordinary run comes to them. *)

open Scc_ctl
open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_state_sets
open Scc_symbolic
module Gen = QCheck2.Gen

let number = Rat.of_int
let most_nodes = 150
let most_states = 600
let horizon = number 6

type case = { scene : Scene.t; props : Property.prop list; seed : int }

let generate =
  let open Gen in
  let* scene = Scene.generate in
  let leaves = List.length scene.bodies in
  let one = Predicates.generate leaves ~timed:scene.timed in
  let+ props = flatten_l [ one 0; one 0; one 1; one 1; one 2; one 2 ] and+ seed = 0 -- 1_000_000 in
  { scene; props; seed }

(* {1 Both sides} *)

type symbolic = {
  graph : Zone_graph.t;
  ended : Zone_graph.end_;
  searches : Search_sets.t list;
  events : Property.event array;
  atoms : Atoms.context;
  context : Instant.context;
}

let distinct events =
  let add kept e = if List.exists (Formula.equal_event e) kept then kept else e :: kept in
  Array.of_list (List.rev (List.fold_left add [] events))

let symbolic case semantics (s : Scene.t) zones =
  let context = Instant.context semantics in
  let events = distinct (List.concat_map (fun p -> Formula.events (State p)) case.props) in
  let atoms = Atoms.context context ~events in
  let bound = if s.timed then Some horizon else None in
  let searches = List.map (Search_sets.make atoms ~parameters:(Scene.parameters s) ~bound) case.props in
  let visitor : Zone_graph.visitor =
    {
      found = ignore;
      late = ignore;
      expanded = (fun node -> List.iter (fun search -> Search_sets.look context search node) searches);
      enough = (fun _ -> false);
      stop = (fun () -> false);
    }
  in
  let limits = { Zone_graph.depth = None; nodes = Some most_nodes; horizon = bound; later = Followed 0 } in
  let graph, ended = Zone_graph.explore context ~events ~limits ~visitor zones in
  let nodes = List.init (Zone_graph.size graph) (Zone_graph.node graph) in
  let around (n : Zone_graph.node) =
    if not n.expanded then List.iter (fun search -> Search_sets.look_around search n) searches
  in
  List.iter around nodes;
  { graph; ended; searches; events; atoms; context }

let nodes g = List.init (Zone_graph.size g.graph) (Zone_graph.node g.graph)

type point = { values : Rat.t array; semantics : Semantics.t; initial : State.t }

(* Time is kept on the ordinary side wherever it stops at given instants. *)
let at (s : Scene.t) standard values =
  let timed = s.timed || s.splits = Any in
  let semantics = Semantics.with_model standard (Scene.model_at s ~timed values) in
  match Network.initial semantics (Scene.declared_at s values) with
  | Ok initial -> { values; semantics; initial }
  | Error _ -> failwith "no initial state"

let show_point p = String.concat ", " (List.map Rat.to_string (Array.to_list p))
let fail case p fmt =
  let fail why = QCheck2.Test.fail_reportf "at %s: %s (seed %d)" (show_point p) why case.seed in
  Printf.ksprintf fail fmt

let explore (s : Scene.t) g p =
  let events = g.events in
  let until = if s.timed || s.splits = Any then Some horizon else None in
  let go instants = Plain.explore p.semantics ~events ~horizon:until ~instants ~limit:most_states p.initial in
  if s.splits = Any then
    let grid = List.init 7 number in
    go (List.sort_uniq Rat.compare (grid @ Plain.times (go grid)))
  else go []

(* {1 Statistics} *)

let scenes = ref 0
let verdicts = ref 0
let positive = ref 0
let states = ref 0
let replayed = ref 0
let exact = ref 0
let unfinished = ref 0
let size = ref 0
let labels = Hashtbl.create 8

let count_labels ~contact g =
  let word : Zone_steps.step -> string = function
    | Passes _ -> "passes"
    | Passes_some -> "passes some"
    | Happens l -> (
        match l with
        | Time _ -> "time"
        | Bind _ -> if contact then "bind, by contact" else "bind"
        | Close _ -> "close"
        | Bounce { firsts; _ } -> if List.length firsts > 2 then "bounce of many" else "bounce"
        | Absorb _ -> "absorb"
        | Weak_split _ -> "weak split"
        | Strong_split _ -> "strong split"
        | Draw _ -> "draw"
        | Lot _ -> "lot")
  in
  let count (e : Zone_graph.edge) =
    let w = word e.step in
    Hashtbl.replace labels w (1 + Option.value (Hashtbl.find_opt labels w) ~default:0)
  in
  List.iter (fun (n : Zone_graph.node) -> List.iter count n.edges) (nodes g)

(* {1 The four laws} *)

(* All that the ordinary rules reach is in some zone. *)
let all_in_zones case (m : Model.t) g p (plain : Plain.t) =
  let all = nodes g in
  let check (v : Plain.visit) =
    incr states;
    let is (n : Zone_graph.node) =
      Bool.equal n.zone.halted v.halted
      && List.equal Int.equal n.zone.arrived v.arrived
      && Replay.is_in m n.zone p.values v.state
    in
    if not (List.exists is all) then
      fail case p.values "a state is in no zone%s, time %s" (if v.halted then " that is halted" else "")
        (match v.state.time with None -> "?" | Some t -> Rat.to_string t)
  in
  List.iter check plain.visits

(* To each zone leads a run that the ordinary rules follow, and what holds at its end holds there. *)
let follows case (m : Model.t) g standard (node : Zone_graph.node) =
  let place prop : Search_sets.place = { node; states = node.zone.set; passing = false; prop } in
  let run = Concrete.run g.graph (place (Bool true)) in
  incr replayed;
  let p = at case.scene standard run.values in
  match Replay.follow p.semantics p.initial run with
  | Error why -> fail case p.values "node %d: no run %s" node.number why
  | Ok ends -> (
      match List.find_opt (Replay.is_in m node.zone p.values) ends with
      | None -> fail case p.values "node %d: the run to it leads elsewhere" node.number
      | Some _ -> ())

(* No state of a run is taken for one that rule WellFormed excludes. *)
let is_well_formed case g (node : Zone_graph.node) =
  let z = node.zone in
  let right = Zone_well_formed.apart g.context { z with set = Zone_well_formed.convex g.context z } in
  let right = Union.of_polyhedra (Zone.dimension z) right in
  match Union.pieces (Union.difference (Union.of_polyhedron z.set) right) with
  | [] -> ()
  | wrong :: _ ->
    let point = Option.get (Polyhedron.point wrong) in
    fail case (Array.map (fun f -> Linear.eval f point) z.parameters) "node %d: not well-formed" node.number

(* The first places that searches found. *)
let finds case g standard search =
  match Search_sets.first search with
  | None -> ()
  | Some place -> (
      let run = Concrete.run g.graph place in
      let p = at case.scene standard run.values in
      match Replay.follow p.semantics p.initial run with
      | Error why -> fail case p.values "no run %s" why
      | Ok ends ->
        let arrived = place.node.zone.arrived in
        let holds state =
          let truth =
            if not place.passing then
              Plain.holds p.semantics ~events:g.events place.prop { state; arrived; halted = false }
            else
              let line = Scc_evaluate.Trajectory.make p.semantics state Forever in
              let truths = Scc_evaluate.Trajectory.predicate p.semantics place.prop line in
              Timeline.at truths (Algebraic.of_rat run.offset)
          in
          Truth.equal truth True
        in
        if not (List.exists holds ends) then fail case p.values "what was found does not hold there")

let in_time (s : Scene.t) prop =
  if s.timed then Property.And [ prop; Compare (Le, Quantity Time, Const horizon) ] else prop

let agree case g p (plain : Plain.t) prop search =
  let s = case.scene in
  let prop = in_time s prop in
  let at_states =
    List.filter (fun (v : Plain.visit) -> not v.halted) plain.visits
    |> List.map (Plain.holds p.semantics ~events:g.events prop)
  in
  let all = at_states @ List.concat_map (Plain.while_passing p.semantics prop) plain.passings in
  let doubtful = List.exists (function Truth.Undecided _ -> true | True | False -> false) all in
  let reached = List.exists (Truth.equal True) all in
  let found = Union.mem (Search_sets.found search) p.values in
  let open_ = Union.mem (Search_sets.open_ search) p.values in
  incr verdicts;
  if reached then incr positive;
  if reached && not (found || open_) then fail case p.values "a run comes to what no zone has";
  if plain.complete && s.splits = Grid then begin
    incr exact;
    if found && not reached then fail case p.values "a zone has what no run comes to";
    if open_ && (not reached) && (not doubtful) && g.ended = Closed then
      fail case p.values "it is not known, but all was seen"
  end

(* {1 Points} *)

let lattice (m : Model.t) =
  let one (r : Ranges.range) =
    let third = Rat.make Z.one (Z.of_int 3) and half = Rat.make Z.one (Z.of_int 2) in
    let between w = Rat.add r.low.value (Rat.mul w (Rat.sub r.high.value r.low.value)) in
    List.filter (Ranges.mem r)
      [ r.low.value; Rat.add r.low.value Rat.one; between half; between third; r.high.value ]
    |> List.sort_uniq Rat.compare
  in
  let before rest v = List.map (fun p -> v :: p) rest in
  Array.fold_right (fun r rest -> List.concat_map (before rest) (one r)) m.ranges [ [] ]
  |> List.map Array.of_list

let borders g (m : Model.t) =
  let ways = [ Polyhedron.corner; Polyhedron.interior_point; Polyhedron.point ] in
  let of_piece p = List.filter_map (fun f -> f p) ways in
  let all = List.concat_map (fun s -> Union.pieces (Search_sets.found s)) g.searches in
  let in_range p = Polyhedron.mem (Ranges.box m.ranges) p in
  List.filter in_range (List.concat_map of_piece all)

let some random n list =
  let a = Array.of_list list in
  let k = Array.length a in
  if k <= n then list else List.init n (fun _ -> a.(Random.State.int random k))

(* {1 One scene} *)

let agrees case =
  let s = case.scene in
  let m = Scene.model s in
  let random = Random.State.make [| case.seed |] in
  let standard = Scc_engine.Standard.of_model m in
  let middle = Option.get (Polyhedron.interior_point (Ranges.box m.ranges)) in
  let initial =
    match Network.initial (Semantics.make { m with keeps_time = false }) (Scene.declared s middle) with
    | Ok s -> s
    | Error _ -> failwith "no initial state"
  in
  match Start.zones (Instant.context standard) (Scene.uncertain s) ~initial ~keeps_time:s.timed with
  | Error { at = values; _ } ->
    let values = Array.of_list (List.map snd values) in
    let p = at s standard values in
    Well_formed.check p.semantics p.initial <> [] || fail case values "nothing is wrong at the start"
  | Ok zones -> (
      let g = symbolic case standard s zones in
      match g.ended with
      | Not_affine _ -> true
      | _ ->
        incr scenes;
        if g.ended <> Closed then incr unfinished;
        size := !size + Zone_graph.size g.graph;
        count_labels ~contact:s.contact g;
        List.iter (follows case m g standard) (some random 20 (nodes g));
        List.iter (is_well_formed case g) (some random 20 (nodes g));
        List.iter (finds case g standard) g.searches;
        let look values =
          let p = at s standard values in
          (match Well_formed.check p.semantics p.initial with
           | [] -> ()
           | _ :: _ -> fail case values "it is not well-formed");
          let plain = explore s g p in
          if g.ended = Closed then all_in_zones case m g p plain;
          List.iter2 (agree case g p plain) case.props g.searches
        in
        List.iter look (some random 5 (lattice m) @ some random 4 (borders g m));
        true)

(* For teeth.py, which does not ask for the least example. *)
let generate = if Sys.getenv_opt "SCC_NO_SHRINKING" = None then generate else Gen.no_shrink generate

let law = QCheck2.Test.make ~name:"zones" ~count:500 ~print:(fun c -> Scene.print c.scene) generate agrees

(* Rates of what has to be among it, which is printed: a test that sees no splits says nothing of them. *)
let enough () =
  Printf.printf "%d scenes (%d unfinished) of %d zones; %d verdicts (%d exact, %d of yes); %d states; %d runs\n"
    !scenes !unfinished !size !verdicts !exact !positive !states !replayed;
  Hashtbl.iter (fun w n -> Printf.printf "%s: %d\n" w n) labels;
  let seen word = Option.value (Hashtbl.find_opt labels word) ~default:0 in
  let at_least word n = Alcotest.(check bool) word true (seen word >= n) in
  List.iter2 at_least
    [
      "bind"; "bind, by contact"; "absorb"; "bounce"; "bounce of many"; "strong split"; "weak split";
      "passes some";
    ]
    [ 30; 75; 50; 500; 2; 15; 250; 50 ]

let () =
  Alcotest.run "zones"
    [ ("random", Scc_test_support.Property.cases [ law ] @ [ Alcotest.test_case "enough" `Quick enough ]) ]
