(* Runs that do otherwise: they are runs, they do, and no run of the definition parts from the other one later. *)

open Scc_ctl
open Scc_exact
open Scc_test_ctl
open Test_explanations

(* As "f until g": the quantifier, the bound, both sides, and whether it holds. *)
let as_until (e : Explanation.t) : (Timed_formula.quantifier * _ * _ * _ * bool) option =
  match e.formula with
  | Until (q, b, f, g) -> Some (q, b, f, g, e.holds)
  | Finally (q, b, g) -> Some (q, b, always, g, e.holds)
  | Globally (q, b, g) -> Some (opposite q, b, always, Not g, not e.holds)
  | Predicate _ | Not _ | And _ | Or _ | Next _ -> None

let rec nodes c clock (run : Run.t) steps =
  match (steps : Run.step list) with
  | [] -> [ (run.last, clock) ]
  | s :: rest ->
    let passed =
      match (s.move, c.graph.nodes.(s.source).flow) with
      | Flow _, Lasts (d, _) -> Rat.mul c.graph.unit (Rat.of_int d)
      | Flow _, (No_flow | Ray _) -> fail c "a step through a flow that does not end"
      | Edge _, _ -> Rat.zero
    in
    (s.source, clock) :: nodes c (Rat.add clock passed) run rest

let otherwise naive q (b : Timed_formula.bound) f g (node, clock) =
  let left x = Rat.sub x clock in
  let bound = { Timed_formula.low = Rat.max Rat.zero (left b.low); high = Option.map left b.high } in
  let a = Naive.node naive (Until (opposite q, bound, f, g)) node in
  Option.fold ~none:true ~some:(fun h -> Rat.sign h >= 0) bound.high
  && match (q : Timed_formula.quantifier) with All -> a.surely | Exists | Chance _ -> not a.perhaps

let does_otherwise c naive q (b : Timed_formula.bound) f g run =
  let w = { Walk.low = b.low; high = b.high } in
  match (Walk.pieces c.graph ~rounds:(rounds w c) run, (q : Timed_formula.quantifier)) with
  | Error text, _ -> fail c "%s" text
  | Ok pieces, All ->
    fst (Walk.until w ~f:(surely c naive f) ~g:(surely c naive g) pieces) = Walk.Met
  | Ok pieces, (Exists | Chance _) ->
    fst (Walk.until w ~f:(perhaps c naive f) ~g:(perhaps c naive g) pieces) <> Walk.Met

let is_decided e f =
  let v = Eval.value e f in
  v.lower == v.upper

let last_index list p =
  snd (List.fold_left (fun (i, found) x -> (i + 1, if p x then Some i else found)) (0, None) list)

let contrasted c =
  let e = Small.evaluator c.graph and naive = Naive.make c.graph in
  match Explanation.explain e c.formula (Positions.start 0) with
  | exception Explanation.Not_known -> true
  | { because = Run { run; _ }; holds; _ } as why -> (
      match as_until why with
      | None -> true
      | Some (q, b, f, g, _) -> (
          let expected = last_index (nodes c Rat.zero run run.steps) (otherwise naive q b f g) in
          match (Contrast.find e c.formula run ~holds, expected) with
          | None, None -> true
          | None, Some _ when not (otherwise naive q b f g (0, Rat.zero)) -> true
          | None, Some k -> fail c "no run, and one may part after %d steps" k
          | Some found, _ ->
            (* What is undecided on the way may end what they share sooner. *)
            let decided = is_decided e f && is_decided e g in
            ensure c "it parts elsewhere" (Some found.shared = expected || not decided);
            ensure c "it starts elsewhere" (same_position run.start found.run.start);
            let first l = List.filteri (fun i _ -> i < found.shared) l in
            ensure c "other steps before" (first run.steps = first found.run.steps);
            ensure c "it does the same" (does_otherwise c naive q b f g found.run);
            true))
  | _ -> true

let suite =
  let test name ~depth ~truncated count =
    QCheck2.Test.make ~count ~name ~print (case_gen ~unsure:truncated ~truncated ~depth) contrasted
  in
  ( "contrast",
    [
      ( "runs that do otherwise",
        Scc_test_support.Property.cases
          [
            test "one operator" ~depth:1 ~truncated:false 4000;
            test "nested operators" ~depth:3 ~truncated:false 1500;
            test "truncated graphs" ~depth:2 ~truncated:true 2000;
          ] );
    ] )
