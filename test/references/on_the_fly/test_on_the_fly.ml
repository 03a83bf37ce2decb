(* The questions of the engine on random small timed graphs, against the naive answers. *)

open Scc_ctl
open Scc_exact
open Scc_graph_search
module Gen = QCheck2.Gen
module Graph = Explore.Make (Toy.System)
module E = On_the_fly.Make (Toy.System) (Graph)

type case = {
  graph : Toy.t;
  asked : int option list;  (** bounds *)
  depth : int option;
  time : int option;
  states : int option;
}

let question g within : E.question =
  {
    within = Option.map Rat.of_int within;
    goal =
      {
        at = (fun s -> Toy.truth g.(s.(0)).Toy.at);
        along = Some (fun s -> Toy.timeline g s.(0));
      };
  }

(* As far as the questions go. *)
let horizon c =
  let bounds = List.map (Option.map Rat.of_int) c.asked in
  match (bounds, Option.map Rat.of_int c.time) with
  | [], limit -> limit
  | _, limit when List.exists Option.is_none bounds -> limit
  | _, limit -> (
      let last = List.fold_left (fun m b -> Rat.max m (Option.get b)) Rat.zero bounds in
      match limit with None -> Some last | Some t -> Some (Rat.min t last))

let run ?order c =
  let limits = { Limits.unlimited with depth = c.depth; time = horizon c; states = c.states } in
  let rests s = Toy.rests c.graph s.(0) in
  E.run ?order ~rests limits Limits.quiet c.graph (List.map (question c.graph) c.asked)

let question_gen = Gen.opt (Gen.int_range 0 8)

let case_gen ~bounded =
  let open Gen in
  let maybe high = if bounded then opt (int_range 0 high) else return None in
  let* graph = Toy.gen in
  let* asked = list_size (int_range 1 3) question_gen in
  let* depth = maybe 4 in
  let* time = maybe 8 in
  let* states = if bounded then opt (int_range 1 7) else return None in
  return { graph; asked; depth; time; states }

let print c =
  let bound = function None -> "-" | Some n -> string_of_int n in
  let asked w = "EF within " ^ bound w in
  Printf.sprintf "%s\n%s\ndepth %s, time %s, states %s" (Toy.print c.graph)
    (String.concat "; " (List.map asked c.asked))
    (bound c.depth) (bound c.time) (bound c.states)

type expected = Certainly | Certainly_not | Open

let expected g within =
  if Toy.possibly g ~within ~unsure:false then Certainly
  else if Toy.possibly g ~within ~unsure:true then Open
  else Certainly_not

let shown = function Certainly -> "yes" | Certainly_not -> "no" | Open -> "unknown"
let answered = function E.Met _ -> Certainly | Never -> Certainly_not | Open _ -> Open
let agree a b = String.equal (shown a) (shown b)

let exact =
  QCheck2.Test.make ~count:8000 ~name:"answers are those of the naive unrolling" ~print
    (case_gen ~bounded:false)
    (fun c -> List.for_all2 (fun q a -> agree (expected c.graph q) (answered a)) c.asked (run c).answers)

let sound =
  QCheck2.Test.make ~count:8000 ~name:"bounds make answers unknown, never wrong" ~print
    (case_gen ~bounded:true) (fun c ->
        List.for_all2
          (fun q a -> match answered a with Open -> true | sure -> agree (expected c.graph q) sure)
          c.asked (run c).answers)

(* {1 Traces} *)

let duration (r : E.result) (s : Graph.step) =
  Graph.duration r.graph (Graph.edges r.graph s.source).(s.choice)

let total r steps = List.fold_left (fun t s -> Rat.add t (duration r s)) Rat.zero steps

let connected (r : E.result) (t : E.trace) =
  let follow at (s : Graph.step) =
    match at with
    | Some i when i = s.source -> Some (Graph.edges r.graph s.source).(s.choice).target
    | _ -> None
  in
  match List.fold_left follow (Some 0) t.steps with Some i -> i = t.last | None -> false

let extent r last = function
  | None -> Timeline.Forever
  | Some k -> Timeline.Lasts (duration r { source = last; choice = k })

let meets c (r : E.result) within (t : E.trace) =
  let state = (Graph.tuple r.graph t.last).(0) in
  let before x =
    match within with None -> true | Some b -> Algebraic.compare_rat x (Rat.of_int b) <= 0
  in
  let start = total r t.steps in
  match t.finish with
  | At_state -> c.graph.(state).at = Toy.T && before (Algebraic.of_rat start)
  | During { choice; sample; _ } ->
    let timeline = Toy.timeline c.graph state (extent r t.last choice) in
    Truth.equal (Timeline.at timeline sample) True && before (Algebraic.add_rat start sample)
  | Repeats _ -> false

let traced c =
  let r = run c in
  let good within (a : E.answer) =
    match a with
    | Met t -> connected r t && meets c r within t
    | Never | Open _ -> true
  in
  List.for_all2 good c.asked r.answers

let traces =
  QCheck2.Test.make ~count:8000 ~name:"traces show what they should" ~print (case_gen ~bounded:true) traced

(* Goals begin at, or right after, whole times. With the order of time the run shown is as early as any. *)
let earliest c =
  let c = { c with asked = [ None ]; depth = None; time = None; states = None } in
  let r = run ~order:Graph.By_time c in
  match r.answers with
  | [ Met t ] ->
    let start = total r t.steps in
    let instant, attained =
      match t.finish with
      | During { moment; _ } -> (Algebraic.add_rat start moment.offset, moment.attained)
      | At_state | Repeats _ -> (Algebraic.of_rat start, true)
    in
    let k = Z.to_int (Rat.floor (Option.get (Algebraic.to_rat instant))) in
    let met_within k = Toy.possibly c.graph ~within:(Some k) ~unsure:false in
    connected r t && meets c r None t && (k = 0 || not (met_within (k - 1))) && Bool.equal attained (met_within k)
  | [ answer ] -> agree (expected c.graph None) (answered answer)
  | _ -> false

let by_time =
  QCheck2.Test.make ~count:5000 ~name:"the order of time finds the earliest" ~print (case_gen ~bounded:false)
    earliest

(* {1 Cycles without duration} *)

let has_instant_cycle g =
  let reachable = Hashtbl.create 8 in
  let targets s = match g.(s).Toy.ahead with Toy.Edges l -> l | Ray _ | Dead_end -> [] in
  let rec visit s =
    if not (Hashtbl.mem reachable s) then begin
      Hashtbl.add reachable s ();
      List.iter (fun e -> visit e.Toy.target) (targets s)
    end
  in
  visit 0;
  let again s =
    let seen = Hashtbl.create 8 in
    let rec go u =
      List.iter
        (fun e ->
           if e.Toy.duration = 0 && not (Hashtbl.mem seen e.target) then begin
             Hashtbl.add seen e.target ();
             go e.target
           end)
        (targets u)
    in
    go s;
    Hashtbl.mem seen s
  in
  Hashtbl.fold (fun s () found -> found || again s) reachable false

let zeno =
  QCheck2.Test.make ~count:5000 ~name:"a reachable cycle without duration is found" ~print
    (Gen.map (fun c -> { c with asked = [] }) (case_gen ~bounded:false))
    (fun c ->
       let r = run c in
       match r.zeno with
       | None -> not (has_instant_cycle c.graph)
       | Some t -> (
           connected r t
           && match t.finish with
           | Repeats k ->
             let cycle = List.filteri (fun i _ -> i >= k) t.steps in
             cycle <> [] && Rat.sign (total r cycle) = 0
           | _ -> false))

(* {1 Cases} *)

let edge ?(cells = [||]) target duration = { Toy.target; duration; cells }
let node ?(at = Toy.F) edges = { Toy.at; ahead = Toy.Edges edges }

let answers graph asked =
  List.map
    (fun a -> shown (answered a))
    (run { graph; asked; depth = None; time = None; states = None }).answers

(* A question about the closed bound: the goal begins right after 2, or at 2. *)
let at_the_bound () =
  let after = [| { Toy.at = F; ahead = Ray [| F; F; F; F; T |] } |] in
  let exactly = [| { Toy.at = F; ahead = Ray [| F; F; F; T; F |] } |] in
  let asked = [ Some 2; Some 3 ] in
  Alcotest.(check (list string)) "right after" [ "no"; "yes" ] (answers after asked);
  Alcotest.(check (list string)) "exactly" [ "yes"; "yes" ] (answers exactly asked)

(* The goal holds in a state that is met at the bound, after a transition that takes no time. *)
let instant_at_the_bound () =
  let goal = { Toy.at = T; ahead = Ray [| T |] } in
  let g = [| node [ edge 1 2 ~cells:[| F; F; F |] ]; node [ edge 2 0 ]; goal |] in
  Alcotest.(check (list string)) "at 2" [ "yes"; "no" ] (answers g [ Some 2; Some 1 ])

(* An endless graph: the goal is met everywhere before depth 5, and the exploration ends by itself. *)
module Endless = struct
  type context = unit
  type fault = unit

  let width () = 1
  let initial () = [| 1 |]

  let successors () (s : int array) =
    Ok (List.map (fun t -> { Lts.label = 1; changes = [| 0; t |] }) [ 2 * s.(0); (2 * s.(0)) + 1 ])

  let reduced _ _ = None
  let entered _ _ = ()
  let transitions _ _ = 1
  let longest _ = 0
  let bits _ _ = 0
  let duration () _ = Rat.one

  include Lts.Alone
end

module Endless_graph = Explore.Make (Endless)
module Endless_engine = On_the_fly.Make (Endless) (Endless_graph)

let ends_early () =
  let at (s : int array) = Truth.of_bool (s.(0) >= 16) in
  let question : Endless_engine.question = { within = None; goal = { at; along = None } } in
  let rests _ = false in
  let r = Endless_engine.run ~rests Limits.unlimited Limits.quiet () [ question ] in
  (match r.answers with
   | [ Met { steps; _ } ] -> Alcotest.(check int) "shortest" 4 (List.length steps)
   | _ -> Alcotest.fail "not found");
  let settled g = Endless_graph.size g >= 40 in
  let r = Endless_engine.run ~settled ~rests Limits.unlimited Limits.quiet () [] in
  Alcotest.(check bool) "few states" true (Endless_graph.size r.graph <= 128)

let () =
  let quick name f = Alcotest.test_case name `Quick f in
  Alcotest.run "engine"
    [
      ("random graphs", Scc_test_support.Property.cases [ exact; sound; traces; by_time; zeno ]);
      ( "cases",
        [
          quick "the bound of time is closed" at_the_bound;
          quick "what takes no time at the bound counts" instant_at_the_bound;
          quick "an endless graph" ends_early;
        ] );
    ]
