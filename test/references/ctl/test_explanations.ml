(* Every explanation is checked: its runs are followed, and what is claimed along them is looked up in the naive
   evaluator. *)

open Scc_ctl
open Scc_exact
open Scc_chance
open Scc_test_ctl
module Gen = QCheck2.Gen

type case = { graph : Small.t; formula : Timed_formula.t }

let print c = Small.print c.graph ^ "\n" ^ Small.print_formula c.formula

let case_gen ~unsure ~truncated ~depth =
  let open Gen in
  let* graph = Small.gen ~unsure ~truncated in
  let* formula = Small.formula_gen graph.unit depth in
  return { graph; formula }

let value c naive f (p : Positions.position) =
  match Walk.cell c.graph p with None -> Naive.node naive f p.node | Some i -> Naive.cell naive f p.node i

let surely c naive f p = (value c naive f p : Naive.answer).surely
let perhaps c naive f p = (value c naive f p : Naive.answer).perhaps
let fail c format =
  Printf.ksprintf (fun text -> QCheck2.Test.fail_reportf "%s\n%s" text (print c)) format

let ensure c text b = if not b then fail c "%s" text
let always : Timed_formula.t = And []

let same_position (p : Positions.position) (q : Positions.position) =
  Int.equal p.node q.node && Algebraic.equal p.offset q.offset

let opposite = Timed_formula.dual

(* Rounds of a cycle until the window is passed, or has been reached and gone through once. *)
let rounds (w : Walk.window) c =
  let far = match w.high with Some h -> h | None -> w.low in
  2 + Z.to_int (Rat.floor (Rat.div far c.graph.unit))

(* Without the position that a run is taken to, which is its last piece. *)
let before_goal (run : Run.t) pieces =
  match Run.goal run with
  | None -> pieces
  | Some _ -> List.filteri (fun i _ -> i < List.length pieces - 1) pieces

(* Where an open interval begins on which f fails, so may g hold. *)
let before_open_end (run : Run.t) pieces =
  match (run.finish, List.rev pieces) with
  | During { moment = { attained = false; offset }; sample }, (last : Walk.piece) :: _ ->
    let begins = Rat.add last.from (Rat.sub (Walk.rational offset) (Walk.rational sample)) in
    List.filter (fun (p : Walk.piece) ->
        Rat.compare p.from begins < 0
        || match p.until with Some t -> Rat.equal t p.from && Rat.equal t begins | None -> false) pieces
  | _ -> before_goal run pieces

let ends_at pieces = match List.rev pieces with [] -> None | (p : Walk.piece) :: _ -> Some p

(* A run within a bound, from a node, is the earliest: within any less there is none. *)
let earliest c naive (b : Timed_formula.bound) f g (run : Run.t) (last : Walk.piece) =
  match b.high with
  | Some _ when Rat.sign b.low = 0 && not (Positions.is_inside run.start) ->
    let before =
      match run.finish with
      | During { moment = { attained = false; offset }; sample } ->
        Rat.add last.from (Rat.sub (Walk.rational offset) (Walk.rational sample))
      | _ -> Rat.sub last.from c.graph.unit
    in
    if Rat.sign before >= 0 then
      let sooner = Timed_formula.Until (Exists, { b with high = Some before }, f, g) in
      ensure c "not the earliest" (not (surely c naive sooner run.start))
  | Some _ | None -> ()

(* Whether a place of a run stands for a position. *)
let stands_for (place : Course.place) (p : Positions.position) =
  Int.equal place.position.node p.node
  &&
  if Course.is_interval place then
    Algebraic.compare place.low p.offset < 0
    && match place.high with None -> true | Some high -> Algebraic.compare p.offset high < 0
  else Algebraic.equal place.position.offset p.offset

(* The steps of a run from one of them on, with two rounds more of what it repeats. *)
let steps_on (run : Run.t) from =
  let drop n l = List.filteri (fun i _ -> i >= n) l in
  let cycle = match run.finish with Repeats k -> drop k run.steps | _ -> [] in
  let round = List.length cycle in
  drop from run.steps @ List.concat (List.init (2 + (List.length run.steps / max 1 round)) (fun _ -> cycle))

let rec is_prefix (a : Run.step list) (b : Run.step list) =
  match (a, b) with
  | [], _ -> true
  | x :: a, y :: b -> Int.equal x.source y.source && x.move = y.move && is_prefix a b
  | _ :: _, [] -> false

(* The runs that an explanation in the course of a run begins with, and that are said to go on as it does. *)
let rec onward (e : Explanation.t) =
  match e.because with
  | Parts parts -> List.concat_map onward parts
  | Run { run; way = Onward place; _ } -> [ (run, place) ]
  | Given | Everywhere _ | Likelihood _ | Run { way = Own; _ } -> []

let check_onward c (outer : Run.t) step ((run : Run.t), place) =
  let rounds = match outer.finish with Repeats _ -> 6 | _ -> 0 in
  let rec on n = if n = 0 then steps_on outer step else on (n - 1) @ steps_on outer (List.length outer.steps) in
  ensure c "another run" (is_prefix run.steps (on rounds));
  match (Run.goal run, place) with
  | None, None -> ()
  | Some goal, Some (place : Course.place) ->
    let closed = { goal with offset = place.position.offset } in
    ensure c "another place" (Int.equal goal.node place.position.node && stands_for place closed)
  | Some _, None | None, Some _ -> fail c "a place without a goal, or a goal without a place"

(* All is looked at where a run is explained, and some of it on the way of a run that is on the way of another. *)
let chosen depth stretches =
  let n = List.length stretches in
  let keep i = depth = 0 || i = 0 || i = n - 1 || i = n / 2 in
  List.filteri (fun i _ -> keep i) stretches

let is_globally : Timed_formula.t -> bool = function Globally _ -> true | _ -> false

(* How likely it is once all is chosen as it is there. *)
let chance_of c (run : Run.t) =
  let step product (s : Run.step) =
    let node = c.graph.nodes.(s.source) in
    match s.move with
    | Edge k when node.drawn ->
      Option.fold ~none:product ~some:(Rat.mul product) (List.nth_opt (Small.chances node) k)
    | Edge _ | Flow _ -> product
  in
  List.fold_left step Rat.one run.steps

(* [holds] is the truth of the U; [show] that of what its right side was made of. *)
let rec check_until ?(depth = 0) c naive q (b : Timed_formula.bound) f g ~holds (e : Explanation.t) =
  let w = { Walk.low = b.low; high = b.high } in
  match e.because with
  | Everywhere (lazy n) ->
    ensure c "something is reached" (n > 0 || Positions.is_inside e.position);
    ensure c "only what no run shows is so everywhere"
      (match (q : Timed_formula.quantifier) with All -> holds | Exists -> not holds | Chance _ -> false)
  | Given | Parts _ -> fail c "an operator without a run"
  | Likelihood { run = None; measured; _ } ->
    let known = if is_globally e.formula then Answer.complement measured.most else measured.least in
    ensure c "no run, and a probability" (Answer.lower known = Some Rat.zero)
  | Likelihood { run = Some (run, chance); measured; parts; _ } -> (
      ensure c "the run starts elsewhere" (same_position run.start e.position);
      ensure c "another probability" (Rat.equal chance (chance_of c run));
      let known = if is_globally e.formula then Answer.complement measured.most else measured.least in
      ensure c "more than all runs together"
        (match Answer.upper known with None -> false | Some p -> Rat.compare chance p <= 0);
      List.iter (check ~depth c naive) parts;
      match Walk.pieces c.graph ~rounds:1 run with
      | Error text -> fail c "%s" text
      | Ok pieces -> (
          match Walk.until w ~f:(surely c naive f) ~g:(surely c naive g) pieces with
          | Met, _ -> (
              match ends_at pieces with
              | Some last ->
                ensure c "it is not met at the end"
                  (surely c naive g last.position && Walk.in_window w last)
              | None -> fail c "an empty run")
          | (Broken | Past | Open), _ -> fail c "the run does not count"))
  | Run { run; parts; along; way } -> (
      ensure c "the run starts elsewhere" (same_position run.start e.position);
      match Walk.pieces c.graph ~rounds:(rounds w c) run with
      | Error text -> fail c "%s" text
      | Ok pieces -> (
          List.iter (fun (p : Explanation.t) ->
              match Run.goal run with
              | Some goal -> ensure c "a part elsewhere" (same_position goal p.position)
              | None -> fail c "a part of a run without end") parts;
          List.iter (check ~depth c naive) parts;
          let before = match (q : Timed_formula.quantifier) with Exists -> before_goal | All | Chance _ ->
            before_open_end in
          let claim, claimed, scope =
            match (q : Timed_formula.quantifier) with
            | Exists -> (f, true, fun _ -> true)
            | All | Chance _ -> (
                match e.formula with
                | Globally (_, _, g) -> (g, true, Walk.in_window w)
                | _ -> (g, false, Walk.in_window w))
          in
          check_along ~depth c naive run claim claimed (List.filter scope (before run pieces)) along;
          match q with
          | Chance _ -> fail c "one run decides a probability"
          | Exists -> (
              ensure c "a run decides E only when it holds" holds;
              ensure c "one part" (List.length parts = 1);
              match Walk.until w ~f:(surely c naive f) ~g:(surely c naive g) pieces with
              | Met, _ -> (
                  (* Not only on the way: at its end. *)
                  match ends_at pieces with
                  | Some last ->
                    (match way with Own -> earliest c naive b f g run last | Onward _ -> ());
                    ensure c "the goal is not met at the end"
                      (surely c naive g last.position
                       && Rat.compare last.from w.low >= 0
                       && match w.high with None -> true | Some h -> Rat.compare last.from h <= 0)
                  | None -> fail c "an empty run")
              | (Broken | Past | Open), _ -> fail c "the run does not show it")
          | All -> (
              ensure c "a run decides A only when it does not hold" (not holds);
              match (Walk.until w ~f:(perhaps c naive f) ~g:(perhaps c naive g) pieces, run.finish) with
              | (Met, _), _ -> fail c "the goal is met"
              | (Broken, rest), (At_state | During _) ->
                let broken (p : Walk.piece) = not (perhaps c naive f p.position) in
                ensure c "it is broken before the end" (List.for_all broken rest);
                ensure c "no part" (parts <> [])
              | (Broken, _), (Rests | Stops | Repeats _ | Passes _) -> fail c "broken on the way"
              | (Open, _), (Rests | Stops) | (Past, _), Repeats _ -> ()
              | (Past, _), (At_state | During _ | Rests | Stops | Passes _) -> fail c "more than is needed"
              | (Open, _), Repeats _ -> ()
              | (Open, _), Passes _ ->
                let at_bound =
                  match (ends_at pieces, w.high) with
                  | Some { from; until = Some t; _ }, Some h -> Rat.equal from h && Rat.equal t h
                  | Some { until = None; _ }, Some _ | _, None | None, _ -> false
                in
                ensure c "it does not end at the bound" at_bound
              | (Open, _), (At_state | During _) -> fail c "the run shows nothing")))

(* What is claimed on the way: of each piece there is a place that stands for it, and a reason there. *)
and check_along ~depth c naive run claim claimed pieces along =
  match (along, (claim : Timed_formula.t)) with
  | None, And [] -> ()
  | None, _ -> fail c "nothing is said of the way"
  | Some a, _ ->
    ensure c "another claim" (Timed_formula.compare a.claim claim = 0 && Bool.equal a.claimed claimed);
    let told (p : Walk.piece) =
      let v = value c naive claim p.position in
      if not (if claimed then v.surely else not v.perhaps) then
        fail c "%s is not so on the way, in %d after %s" (Small.print_formula claim) p.position.node
          (Algebraic.to_string p.position.offset);
      ensure c "a piece without a place"
        (List.exists (fun (s : Explanation.stretch) -> stands_for s.place p.position) a.stretches)
    in
    List.iter told pieces;
    let stretch (s : Explanation.stretch) =
      let why = Lazy.force s.why in
      ensure c "a reason elsewhere" (same_position why.position s.place.position);
      ensure c "a reason of something else"
        (Timed_formula.compare why.formula claim = 0 && Bool.equal why.holds claimed);
      List.iter (check_onward c run s.place.step) (onward why);
      check ~depth:(depth + 1) c naive why
    in
    List.iter stretch (chosen depth a.stretches)

and check_next ~depth c naive f ~wanted (e : Explanation.t) =
  match e.because with
  | Everywhere (lazy n) -> ensure c "something is reached" (n > 0 || Positions.is_inside e.position)
  | Given | Parts _ | Likelihood _ -> fail c "an operator without a run"
  | Run { run; parts; _ } ->
    (match Walk.pieces c.graph ~rounds:1 run with Ok _ -> () | Error text -> fail c "%s" text);
    ensure c "it starts elsewhere" (same_position run.start e.position);
    let is_edge (s : Run.step) = match s.move with Edge _ -> true | Flow _ -> false in
    (match List.rev run.steps with
     | last :: before -> ensure c "one edge, at last" (is_edge last && not (List.exists is_edge before))
     | [] -> fail c "no edge");
    (match parts with
     | [ p ] ->
       ensure c "the part" (same_position p.position (Positions.start run.last));
       ensure c "of the formula" (Timed_formula.compare p.formula f = 0 && Bool.equal p.holds wanted)
     | _ -> fail c "not one part");
    List.iter (check ~depth c naive) parts

and check ?(depth = 0) c naive (e : Explanation.t) =
  let a = value c naive e.formula e.position in
  ensure c "it is as claimed" (if e.holds then a.surely else not a.perhaps);
  let parts l =
    List.iter
      (fun (p : Explanation.t) ->
         ensure c "a part elsewhere" (same_position p.position e.position);
         check ~depth c naive p)
      l
  in
  match (e.formula, e.because) with
  | Predicate _, Given -> ()
  | Not _, Parts [ p ] ->
    ensure c "not" (not (Bool.equal p.holds e.holds));
    parts [ p ]
  | And fs, Parts l ->
    let all = List.length l = List.length fs in
    ensure c "and" (if e.holds then all else List.exists (fun (p : Explanation.t) -> not p.holds) l);
    parts l
  | Or fs, Parts l ->
    let all = List.length l = List.length fs in
    ensure c "or" (if e.holds then List.exists (fun (p : Explanation.t) -> p.holds) l else all);
    parts l
  | Next (q, f), _ ->
    let by_run = match q with Exists -> e.holds | All | Chance _ -> not e.holds in
    (match e.because with
     | Run _ -> ensure c "a run" by_run
     | _ -> ensure c "no run" (not by_run));
    check_next ~depth c naive f ~wanted:e.holds e
  | Until (q, b, f, g), _ -> check_until ~depth c naive q b f g ~holds:e.holds e
  | Finally (q, b, g), _ -> check_until ~depth c naive q b always g ~holds:e.holds e
  | Globally (q, b, g), _ -> check_until ~depth c naive (opposite q) b always (Not g) ~holds:(not e.holds) e
  | (Predicate _ | Not _ | And _ | Or _), _ -> fail c "an explanation of another kind"

let check_chain c (e : Explanation.t) =
  match Explanation.chain e with
  | None -> ()
  | Some run -> (
      ensure c "the chain starts elsewhere" (same_position run.start e.position);
      match Walk.pieces c.graph ~rounds:2 run with Ok _ -> () | Error text -> fail c "chain: %s" text)

let everywhere c =
  let nodes = List.init (Array.length c.graph.nodes) Positions.start in
  let inside s =
    let x = c.graph.nodes.(s) in
    if x.known then
      List.init (Small.cells x) (fun i -> { Positions.node = s; offset = Small.offset c.graph i })
    else []
  in
  nodes @ List.concat_map inside (List.init (Array.length c.graph.nodes) Fun.id)

let explained c =
  let e = Small.evaluator c.graph and naive = Naive.make c.graph in
  List.iter
    (fun p ->
       match (Explanation.explain e c.formula p, Eval.truth e c.formula p) with
       | exception Explanation.Not_known ->
         ensure c "decided and not explained" (Option.is_none (Eval.truth e c.formula p))
       | _, None -> fail c "explained and not decided"
       | x, Some v ->
         ensure c "another truth" (Bool.equal x.holds v);
         check c naive x;
         check_chain c x)
    (everywhere c);
  true

let explanations name ~unsure ~truncated ~depth count =
  QCheck2.Test.make ~count ~name ~print (case_gen ~unsure ~truncated ~depth) explained

(* {1 Doubts} *)

let doubts e c = Doubts.find e c.formula (Positions.start 0)

let doubted c =
  let e = Small.evaluator c.graph in
  let d = doubts e c in
  let none = d.unexplored = [] && List.length d.undefined = 0 in
  let undecided = Option.is_none (Eval.truth e c.formula (Positions.start 0)) in
  ensure c "doubts where it is undecided, and only there" (Bool.equal none (not undecided));
  List.iter (fun s -> ensure c "a known node" (not c.graph.nodes.(s).known)) d.unexplored;
  List.iter
    (fun (u : Doubts.undefined) ->
       match Eval.truth e (Predicate u.predicate) u.position with
       | None -> ()
       | Some _ -> fail c "a predicate that is decided")
    d.undefined;
  true

(* Where everything is known, all is decided: runs that go round within one instant are runs. *)
let decided c =
  let e = Small.evaluator c.graph in
  let d = doubts e c in
  ensure c "nothing to doubt" (d.unexplored = [] && List.length d.undefined = 0);
  ensure c "undecided" (Option.is_some (Eval.truth e c.formula (Positions.start 0)));
  true

(* When only unexplored nodes matter, it is decided once they are known to lead nowhere. *)
let settled c =
  let e = Small.evaluator c.graph in
  let d = doubts e c in
  let close s (x : Small.node) =
    if List.mem s d.unexplored then { x with known = true; edges = []; flow = Small.No_flow } else x
  in
  let closed = { c with graph = { c.graph with nodes = Array.mapi close c.graph.nodes } } in
  (match d.undefined with
   | [] ->
     let e = Small.evaluator closed.graph in
     ensure c "still undecided" (Option.is_some (Eval.truth e c.formula (Positions.start 0)))
   | _ :: _ -> ());
  true

let test name ~unsure ~truncated ~depth count f =
  QCheck2.Test.make ~count ~name ~print (case_gen ~unsure ~truncated ~depth) f

let suite =
  ("explanations",
   [
     ( "explanations",
       Scc_test_support.Property.cases
         [
           explanations "one operator" ~unsure:false ~truncated:false ~depth:1 2000;
           explanations "nested operators" ~unsure:false ~truncated:false ~depth:3 1200;
           explanations "nested deeper" ~unsure:false ~truncated:false ~depth:4 400;
           explanations "undecided predicates, truncated graphs" ~unsure:true ~truncated:true ~depth:2 1200;
         ] );
     ( "doubts",
       Scc_test_support.Property.cases
         [
           test "what cannot be decided" ~unsure:true ~truncated:true ~depth:3 3000 doubted;
           test "nothing is in doubt where all is known" ~unsure:false ~truncated:false ~depth:3 4000 decided;
           test "which unexplored nodes matter" ~unsure:false ~truncated:true ~depth:3 3000 settled;
         ] );
   ])
