(* The graph of all owners: what is sent of it comes, and nothing else is taken for it. *)

open Scc_exact
open Scc_ctl
open Scc_successors
open Scc_owners

let folder = "../../../specs/models"

let read_file name =
  let channel = open_in_bin (Filename.concat folder name) in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  Ok text

(* With probabilities, a mean of a number of events, and one of a number at a time. *)
let wanted name =
  let text = Result.get_ok (read_file name) in
  match Scc_loading.Loaded.load ~read_file ~overrides:[] (Scc_base.Source.make ~name text) with
  | Error _ -> Alcotest.failf "%s is not loaded" name
  | Ok l -> (
      match Question.make ~reductions:Question.reductions ~bits:1000 ~names:[] ~number:1 l with
      | Ok q -> Wanted.find (Filter.make q)
      | Error _ -> Alcotest.fail "there is no such question")

let predicates (w : Wanted.t) = Array.length (Scc_state_space.Formulas.predicates w.formulas)

(* {1 Graphs by chance} *)

let pick all = List.nth all (Random.int (List.length all))
let half = Rat.make Z.one (Z.of_int 2)

let follows () : Node.follows =
  let step duration chance = { Node.duration; chance } in
  let some f = Array.init (Random.int 4) (fun _ -> f ()) in
  match Random.int 5 with
  | 0 -> Unknown
  | 1 -> Rests
  | 2 -> Steps [| step Rat.zero (Some half); step Rat.zero (Some half); step Rat.zero None |]
  | 3 -> Steps (some (fun () -> step Rat.zero None))
  | _ -> Steps (some (fun () -> pick [ step Rat.one None; step Rat.zero None ]))

let truth () : Truth.t = pick [ Truth.True; False; Undecided "why"; Undecided "so" ]

let timeline extent =
  let cut offset : Truth.t Timeline.piece =
    { cut = Algebraic.of_rat offset; at = truth (); after = truth () }
  in
  Timeline.of_pieces extent ~start:(truth ()) ~first:(truth ()) (if Random.bool () then [ cut half ] else [])

let node (w : Wanted.t) number : Node.t =
  let follows = follows () in
  let along =
    match Node.extent follows with
    | Instant -> []
    | extent when predicates w > 0 -> List.map (fun t -> (0, t)) (Option.to_list (timeline extent))
    | _ -> []
  in
  let at_once = match follows with
    | Steps all -> List.filter (fun (s : Node.step) -> Rat.sign s.duration = 0) (Array.to_list all)
    | Unknown | Rests -> []
  in
  let count _ = Array.of_list (List.map (fun _ -> (Random.int 2, Random.int 3)) at_once) in
  {
    number; follows; along;
    truths = Array.init (predicates w) (fun _ -> truth ());
    counts = List.map count (Array.to_list w.patterns);
  }

type sent = { nodes : Node.t array; targets : int array array; texts : string array; arcs : string list }

let owners = 3

let sent w size =
  let nodes = Array.init size (node w) in
  let steps (n : Node.t) = match n.follows with Steps all -> Array.length all | Unknown | Rests -> 0 in
  let targets = Array.map (fun n -> Array.init (steps n) (fun _ -> Random.int size)) nodes in
  let of_owner owner =
    let b = Buffer.create 100 and direction = Node.direction () in
    Array.iteri (fun k n -> if k mod owners = owner then Node.put direction b n) nodes;
    Buffer.contents b
  in
  let of_source source all =
    let b = Buffer.create 100 in
    Array.iteri (fun choice target -> Gathered.put_arc b ~source ~choice target) all;
    Buffer.contents b
  in
  {
    nodes; targets;
    texts = Array.init owners of_owner;
    arcs = Array.to_list (Array.mapi of_source targets);
  }

let come w size s =
  let g = Gathered.make ~size ~owners w in
  (* Transitions may come before their sources. *)
  let before, after = List.partition (fun _ -> Random.bool ()) s.arcs in
  List.iter (Gathered.arcs g) before;
  Array.iteri (Gathered.nodes g) s.texts;
  List.iter (Gathered.arcs g) after;
  Gathered.finish g;
  g

(* {1 Laws} *)

let check_node w g graph s k (n : Node.t) =
  let is what b = if not b then Alcotest.failf "node %d: %s" k what in
  let steps = match n.follows with Steps all -> Array.to_list all | Unknown | Rests -> [] in
  let all = List.mapi (fun i step -> (step, s.targets.(k).(i))) steps in
  let timed ((step : Node.step), _) = Rat.sign step.duration > 0 in
  let targets list = Array.of_list (List.map snd list) in
  let late, at_once = List.partition timed all in
  is "known" (Bool.equal (graph.Timed_graph.known k) (n.follows <> Unknown));
  is "edges" (graph.edges k = targets at_once);
  (match (n.follows, late, graph.flow k) with
   | Rests, _, Forever -> ()
   | _, (step, _) :: _, Lasts (d, ends) -> is "flow" (Rat.equal d step.duration && ends = targets late)
   | (Unknown | Steps _), [], No_flow -> ()
   | _ -> is "flow" false);
  let chances = List.map (fun ((step : Node.step), _) -> step.chance) at_once in
  let found = Option.map Array.to_list (graph.drawn k) in
  let drawn = if List.exists Option.is_some chances then Some chances else None in
  is "chances" (Option.equal (List.equal (Option.equal Rat.equal)) found drawn);
  Array.iteri (fun p t -> is "truths" (Truth.equal t ((Gathered.predicates g).at p k))) n.truths;
  let along (p, (t : Truth.t Timeline.t)) =
    let found = (Gathered.predicates g).along p k t.extent in
    is "along" (Truth.equal t.first found.first && List.length t.rest = List.length found.rest)
  in
  List.iter along n.along;
  let count pattern all = Array.iteri (fun e x -> is "counts" (Gathered.counted g pattern k e = x)) all in
  List.iteri count n.counts;
  is "home" (Gathered.home g k = (k mod owners, k / owners));
  ignore w

let models = [ "brownian.sc"; "ruin.sc"; "association.sc" ]

let comes () =
  let one name =
    let w = wanted name in
    for size = 1 to 60 do
      let s = sent w size in
      let g = come w size s in
      Array.iteri (check_node w g (Gathered.graph g) s) s.nodes
    done
  in
  List.iter one models

(* A byte is another one, or the text is shorter. *)
let damaged text =
  let n = String.length text in
  if n = 0 then "\001"
  else if Random.int 3 = 0 then String.sub text 0 (Random.int n)
  else begin
    let bytes = Bytes.of_string text in
    Bytes.set bytes (Random.int n) (Char.chr (Random.int 256));
    Bytes.to_string bytes
  end

let nothing_else () =
  let w = wanted "brownian.sc" and refused = ref 0 in
  for _ = 1 to 3000 do
    let size = 1 + Random.int 9 in
    let s = sent w size in
    let damage text = if Random.int 3 = 0 then damaged text else text in
    match come w size { s with texts = Array.map damage s.texts; arcs = List.map damage s.arcs } with
    | g ->
      let graph = Gathered.graph g in
      for k = 0 to size - 1 do
        ignore (graph.edges k);
        ignore (graph.flow k)
      done
    | exception Scc_codec.Packed.Malformed _ -> incr refused
  done;
  if !refused < 300 then Alcotest.failf "only %d graphs were refused" !refused

let missing () =
  let w = wanted "ruin.sc" in
  let refused s =
    match come w 20 s with
    | _ -> Alcotest.fail "a graph is taken, though something is missing"
    | exception Scc_codec.Packed.Malformed _ -> ()
  in
  for _ = 1 to 20 do
    let s = sent w 20 in
    refused { s with texts = Array.mapi (fun k text -> if k = 1 then "" else text) s.texts };
    if List.exists (fun text -> text <> "") s.arcs then refused { s with arcs = [] }
  done

let () =
  Random.init 53;
  Alcotest.run "graph"
    [
      ( "gathered",
        [
          Alcotest.test_case "what is sent comes" `Quick comes;
          Alcotest.test_case "and nothing else" `Quick nothing_else;
          Alcotest.test_case "and no less" `Quick missing;
        ] );
    ]
