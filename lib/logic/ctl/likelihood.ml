open Scc_data
open Scc_exact
open Scc_chance
open Decisions

type question = Decisions.question = {
  graph : Timed_graph.t;
  side : Timed_formula.side;
  bound : Timed_formula.bound;
  f : Positions.t;
  g : Positions.t;
  generous : bool;
}

(* {1 Solving} *)

(* Layer by layer where a bound of time allows it, or as one system of equations. *)
type solution = By_layers of (next -> Answer.t) | Whole of built * Solution.t
type process = { question : question; seen_from : window; solution : solution }

let solve_whole q effort w starts =
  let built = build ~choices:(choices q w) starts in
  (built, Reach.solve (until built) (direction q.side) effort ~asked:(States built.asked))

let all_time = { Timed_formula.low = Rat.zero; high = None }

(* At most what each node has without a bound of time: each scheduler has no less then. *)
let without_bound q effort =
  let q = { q with bound = all_time } in
  let w = window q in
  let start s = next q w (place w s Rat.zero) in
  let built, solution = solve_whole q effort w (List.init q.graph.size start) in
  fun s -> Option.value (Answer.upper (Solution.value solution (number built (start s)))) ~default:Rat.one

(* Rounded up to a multiple of 2^-128, so that all of them have a short denominator. *)
let rounded_up (x : Rat.t) = Rat.make (Z.cdiv (Z.shift_left x.num 128) x.den) (Z.shift_left Z.one 128)

(* With layers up to a time alone, where runs that go on later count as much as [later] tells of their node. *)
let up_to q effort w starts time later =
  let counted b =
    match b.next with
    | Go { node; elapsed = Some e } when Rat.compare e time > 0 ->
      { b with next = Goal; reward = later node }
    | Goal -> { b with reward = Rat.one }
    | Fail | Go _ -> b
  in
  let choices p = List.map (List.map counted) (choices q w p) in
  Layers.means q.graph q.side ~choices time starts
  |> Option.map (fun layers -> Layered.value (Layered.solve layers effort))

(* Choices before the window would count for those within. *)
let enclosed q effort w starts time ~most_of =
  let effort = { effort with Effort.engine = Nearly } in
  let most s = rounded_up (most_of s) in
  let at_once = function
    | Goal -> Answer.Exact Rat.one
    | Fail -> Exact Rat.zero
    | Go p -> Within (Rat.zero, most p.node)
  in
  if Algebraic.compare_rat w.low Rat.zero > 0 then at_once
  else
    match (up_to q effort w starts time (fun _ -> Rat.zero), up_to q effort w starts time most) with
    | Some low, Some high -> (
        fun next ->
          match (Answer.lower (low next), Answer.upper (high next)) with
          | Some x, Some y when Rat.compare x y < 0 -> Within (x, y)
          | Some x, _ -> Exact x
          | None, _ -> at_once next)
    | None, _ | _, None -> at_once

let narrow = Rat.make Z.one (Z.shift_left Z.one 100)

let is_narrow = function
  | Answer.Within (x, y) -> Rat.compare (Rat.sub y x) narrow <= 0
  | Exact _ | At_least _ | Infinite -> true

(* Where layers are many, the first ones as a rule decide: then what is left to be decided is little. *)
let rec by_layers q effort w starts ~most_of ~most =
  match Layers.until ~most q w starts with
  | Some layers -> Some (Layered.value (Layered.solve layers effort))
  | None -> None
  | exception Layers.Too_many time ->
    let found = enclosed q effort w starts time ~most_of:(Lazy.force most_of) in
    let narrow = List.for_all (fun s -> is_narrow (found s)) starts in
    if narrow || most >= Effort.most_layers effort || effort.interrupted () then Some found
    else by_layers q effort w starts ~most_of ~most:(4 * most)

let solve q effort w starts =
  let most_of = lazy (without_bound q effort) in
  let solution =
    match by_layers q effort w starts ~most_of ~most:effort.Effort.layers with
    | Some value -> By_layers value
    | None ->
      let built, solution = solve_whole q effort w starts in
      Whole (built, solution)
  in
  { question = q; seen_from = w; solution }

let value process next =
  match process.solution with
  | By_layers value -> value next
  | Whole (built, solution) -> Solution.value solution (number built next)

let within q effort w starts = value (solve q effort w starts)

let best (side : Timed_formula.side) answers =
  let ends f = List.filter_map f answers in
  let pick list =
    match (side, list) with
    | _, [] -> Scc_base.Bug.fail __POS__ "nothing comes next"
    | Least, x :: rest -> List.fold_left Rat.min x rest
    | Greatest, x :: rest -> List.fold_left Rat.max x rest
  in
  let low = pick (ends Answer.lower) and high = pick (ends Answer.upper) in
  if Rat.equal low high then Answer.Exact low else Within (low, high)

let nexts choices = List.concat_map (List.map (fun b -> b.next)) choices

let at q effort position =
  let w, choices = from q position in
  let process = solve q effort w (nexts choices) in
  best q.side (List.map (value process) (nexts choices))

(* What is not known may be nothing that matters: then one solution is both. *)
let at_both low high effort position =
  let w, choices = from low position in
  let process = solve low effort w (nexts choices) in
  let least = best low.side (List.map (value process) (nexts choices)) in
  let same =
    match process.solution with
    | By_layers _ -> false
    | Whole (built, _) ->
      let w, choices = from high position in
      same_process built (build ~choices:(Decisions.choices high w) (nexts choices))
  in
  (least, if same then least else at high effort position)

(* {1 Sets of positions} *)

(* The times, since the node was entered, at which something changes that a run from its flow on may see. *)
let instants q w s d =
  let horizon = match w.high with None -> w.low | Some h -> h in
  let limit = Algebraic.add_rat d horizon in
  let seen = Places.create 64 and found = ref [] and waiting = Queue.create () in
  let note e p = Array.iter (fun c -> found := Algebraic.add_rat e c :: !found) p.Pieces.cuts in
  let along e node =
    note e (Positions.along q.f node);
    note e (Positions.along q.g node)
  in
  let enter node e =
    let p = { node; elapsed = Some e } in
    if Algebraic.compare_rat limit e >= 0 && not (Places.mem seen p) then begin
      Places.add seen p ();
      found := Algebraic.of_rat e :: !found;
      Queue.add (node, e) waiting
    end
  in
  along Rat.zero s;
  Array.iter (fun t -> enter t d) (Timed_graph.targets (Timed_graph.flow q.graph s));
  let rec go () =
    match Queue.take_opt waiting with
    | None -> !found
    | Some (s, e) ->
      Array.iter (fun t -> enter t e) (Timed_graph.edges q.graph s);
      (match Timed_graph.flow q.graph s with
       | No_flow -> ()
       | Forever -> along e s
       | Lasts (d, targets) ->
         along e s;
         Array.iter (fun t -> enter t (Rat.add e d)) targets);
      go ()
  in
  go ()

let before t b = Algebraic.add_rat (Rat.neg b) t

(* Inside the flow of a node where a bound of time matters: piece by piece. *)
let by_pieces q effort w s (flow : Timed_graph.flow) yes =
  let d = match flow with Lasts (d, _) -> d | No_flow | Forever -> Rat.zero in
  let at_ends t = t :: before t q.bound.low :: Option.to_list (Option.map (before t) q.bound.high) in
  let cuts = List.concat_map at_ends (instants q w s d) in
  Pieces.build ~limit:(limit flow) cuts (fun offset -> yes (at q effort { Positions.node = s; offset }))

(* Where no bound matters: g is met in the flow, or f fails, or what is at its end counts. *)
let by_ending q process s (flow : Timed_graph.flow) yes =
  let f = Positions.along q.f s and g = Positions.along q.g s in
  let reached = Flow.inside ~f ~g false and not_lost = Flow.inside ~f ~g true in
  let at_end =
    match flow with
    | No_flow | Forever -> Answer.Exact Rat.zero
    | Lasts (_, targets) ->
      let value t = value process (next q process.seen_from { node = t; elapsed = None }) in
      best q.side (List.map value (Array.to_list targets))
  in
  let met = yes (Answer.Exact Rat.one) and ended = yes at_end and lost = yes (Answer.Exact Rat.zero) in
  let otherwise = Pieces.map2 (fun _ n -> if n then ended else lost) reached not_lost in
  Pieces.map2 (fun r rest -> if r then met else rest) reached otherwise

let set q effort yes =
  let w = window q in
  let start s = next q w (place w s Rat.zero) in
  let process = solve q effort w (List.init q.graph.size start) in
  let along s =
    match Timed_graph.flow q.graph s with
    | No_flow -> Pieces.constant false
    | flow -> if is_unbounded q then by_ending q process s flow yes else by_pieces q effort w s flow yes
  in
  Positions.make q.graph ~at:(fun s -> yes (value process (start s))) ~along

(* {1 Runs} *)

(* In the flow of a node, where g begins to hold in time. *)
let finish q w (p : place) (moment : Timeline.moment) =
  let limit = Option.map2 (fun e -> Algebraic.add_rat (Rat.neg e)) p.elapsed w.high in
  Run.during q.graph ~f:q.f ~g:q.g ?limit p.node moment

let start_of w (position : Positions.position) = place w position.node Rat.zero

type trail = { source : place; branch : branch }

let to_run q w position trail : Run.t * Rat.t =
  let step t = match t.branch.way with Move move -> Some { Run.source = t.source.node; move } | _ -> None in
  let chance = List.fold_left (fun product t -> Rat.mul product t.branch.probability) Rat.one trail in
  let finish, last =
    match trail with
    | { source; branch = { way = During moment; _ } } :: _ -> (finish q w source moment, source.node)
    | { source; branch = { way = Move move; _ } } :: _ -> (Run.At_state, Timed_graph.target q.graph source.node
                                                             move)
    | _ -> (Run.At_state, position.Positions.node)
  in
  ({ start = position; steps = List.filter_map step (List.rev trail); last; finish }, chance)

(* Those of the choices that a position begins with which attain what is best. *)
let first_choice process = function
  | [ only ] -> only
  | several ->
    let process = process () in
    let answer branches = List.map (fun b -> value process b.next) branches in
    let wanted = best process.question.side (List.concat_map answer several) in
    let same (a : Answer.t) = match (a, wanted) with Exact x, Exact y -> Rat.equal x y | _ -> false in
    Option.value (List.find_opt (fun c -> List.exists same (answer c)) several) ~default:[]

(* Breadth first through what the scheduler chooses. *)
let run_of_whole q effort w position first =
  let built, solution = solve_whole q effort w (nexts first) in
  let process () = { question = q; seen_from = w; solution = Whole (built, solution) } in
  let scheduler = Solution.scheduler solution in
  let found = Bits.create (Growable.length built.places + 2) and waiting = Queue.create () in
  let enter trail source branch =
    let n = number built branch.next in
    if not (Bits.mem found n) then begin
      Bits.add found n;
      Queue.add (branch.next, { source; branch } :: trail) waiting
    end
  in
  List.iter (enter [] (start_of w position)) (first_choice process first);
  let rec go () =
    match Queue.take_opt waiting with
    | None -> None
    | Some (Goal, trail) -> Some (to_run q w position trail)
    | Some (Fail, _) -> go ()
    | Some (Go p, trail) ->
      List.iter (enter trail p) (List.nth (choices q w p) scheduler.(Places.find built.numbers p));
      go ()
  in
  go ()

(* Each choice with which a position begins has one branch. *)
let run_of_layers q effort w position first layers =
  let solved () = By_layers (Layered.value (Layered.solve layers effort)) in
  let process () = { question = q; seen_from = w; solution = solved () } in
  match first_choice process first with
  | [ branch ] ->
    let begun = { source = start_of w position; branch } in
    let trail rest = List.rev (begun :: List.map (fun (source, branch) -> { source; branch }) rest) in
    Option.map (fun rest -> to_run q w position (trail rest)) (Layered.run layers effort branch.next)
  | _ -> None

let run q effort position =
  let w, first = from q position in
  match Layers.until ~most:effort.Effort.layers q w (nexts first) with
  | exception Layers.Too_many _ -> None
  | Some layers -> run_of_layers q effort w position first layers
  | None -> run_of_whole q effort w position first
