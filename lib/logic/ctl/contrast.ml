open Scc_exact

type t = { run : Run.t; shared : int }

(* The nodes of a run before each of its steps, the last one after all, and the time that has passed there. *)
let nodes graph (run : Run.t) =
  let passed (step : Run.step) =
    match step.move with
    | Edge _ -> Rat.zero
    | Flow _ -> (
        match Timed_graph.flow graph step.source with
        | Lasts (d, _) -> d
        | Forever | No_flow -> Scc_base.Bug.fail __POS__ "a step through a flow that does not end")
  in
  let add (clock, found) (step : Run.step) = (Rat.add clock (passed step), (step.source, clock) :: found) in
  let clock, found = List.fold_left add (Rat.zero, []) run.steps in
  Array.of_list (List.rev ((run.last, clock) :: found))

let shifted (b : Timed_formula.bound) clock =
  let left x = Rat.sub x clock in
  { Timed_formula.low = Rat.max Rat.zero (left b.low); high = Option.map left b.high }

let in_time (b : Timed_formula.bound) = Option.fold ~none:true ~some:(fun h -> Rat.sign h >= 0) b.high

(* How many steps may be shared: until some place of the run where it is not known that a run may go on otherwise
   from there. To come to g, f has to hold; not to come to it, g has to fail within the bound. *)
let sound e (u : Eval.until) run ~comes =
  let course = Course.make e [ u.left; u.right ] run in
  let is f wanted (place : Course.place) = Eval.truth e f place.position = Some wanted in
  let all = List.init (Array.length course.places) Fun.id in
  let places, fits = if comes then (all, is u.left true) else (Course.within course u.bound, is u.right false) in
  let bad k = not (fits course.places.(k)) in
  match List.find_opt bad places with
  | Some k -> course.places.(k).step
  | None -> List.length run.steps

(* [holds] of what the run shows: of "all" that it is not so, of "some" that it is. *)
let find e formula (run : Run.t) ~holds =
  match Eval.as_until e formula with
  | None -> None
  | Some (u, flipped) -> (
      let holds = Bool.equal holds (not flipped) in
      match (u.quantifier, holds) with
      | Chance _, _ | All, true | Exists, false -> None
      | All, false | Exists, true ->
        let quantifier = Timed_formula.dual u.quantifier in
        let nodes = nodes (Eval.graph e) run in
        let from k =
          let node, clock = nodes.(k) in
          let bound = shifted u.bound clock in
          let rest = { u with quantifier; bound } in
          let whole = Timed_formula.Until (quantifier, bound, u.left, u.right) in
          match Eval.truth e whole (Positions.start node) with
          | Some truth when in_time bound && Bool.equal truth (not holds) -> Some (rest, Positions.start node)
          | Some _ | None -> None
        in
        (* If some run does otherwise from a node, one does from all before it. *)
        let rec last low found high =
          if high - low <= 1 then Some (low, found)
          else
            let middle = (low + high) / 2 in
            match from middle with
            | Some found -> last middle found high
            | None -> last low found middle
        in
        let continued (shared, (rest, (start : Positions.position))) =
          let rest = (if holds then Deciding_run.every else Deciding_run.some) e rest start in
          let steps = List.filteri (fun i _ -> i < shared) run.steps in
          { run = Run.append { run with steps; last = start.node; finish = At_state } rest; shared }
        in
        let most = sound e u run ~comes:(not holds) in
        Option.map continued (Option.bind (from 0) (fun found -> last 0 found (most + 1))))

let explain e (x : Explanation.t) =
  match x.because with
  | Run { run; way; parts = _; along = _ } ->
    let explained { run; shared } =
      let u = Option.map fst (Eval.as_until e x.formula) in
      let at_goal (u : Eval.until) goal =
        let reason f wanted =
          match Eval.truth e f goal with
          | Some truth when Bool.equal truth wanted -> [ Explanation.explain e f goal ]
          | Some _ | None -> []
        in
        match reason u.right true with [] -> reason u.claim false | reasons -> reasons
      in
      let parts =
        match (u, Run.goal run) with Some u, Some goal -> at_goal u goal | None, _ | _, None -> []
      in
      ({ x with holds = not x.holds; because = Run { run; way; parts; along = None } }, shared)
    in
    Option.map explained (find e x.formula run ~holds:x.holds)
  | Given | Parts _ | Everywhere _ | Likelihood _ -> None
