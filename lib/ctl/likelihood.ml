open Scc_data
open Scc_exact
open Scc_chance

type question = {
  graph : Timed_graph.t;
  side : Formula.side;
  bound : Formula.bound;
  f : Positions.t;
  g : Positions.t;
  generous : bool;
}

(* {1 The decision process} *)

(* Of the time since the run entered the node that it began in, or in whose flow. *)
type window = { low : Algebraic.t; high : Algebraic.t option }

(* A node, and that time; [None] where all that comes is in the window. *)
type place = { node : int; elapsed : Rat.t option }

module Places = Hashtbl.Make (struct
    type t = place

    let equal a b = Int.equal a.node b.node && Option.equal Rat.equal a.elapsed b.elapsed
    let hash p = (p.node * 31) + Option.fold ~none:0 ~some:Rat.hash p.elapsed
  end)

type next = Goal | Fail | Go of place

(* How a place is left, or where in its flow g is met. *)
type way = Move of Timed_graph.move | During of Timeline.moment | Nowhere

type branch = { way : way; next : next; probability : Rat.t }

let is_open w = Option.is_none w.high

let place w node elapsed =
  let within = is_open w && Algebraic.compare_rat w.low elapsed <= 0 in
  { node; elapsed = (if within then None else Some elapsed) }

let after w (p : place) node time =
  match p.elapsed with None -> { node; elapsed = None } | Some e -> place w node (Rat.add e time)

let reaches_beyond w time = match w.high with None -> false | Some h -> Algebraic.compare time h > 0
let in_window w time = Algebraic.compare w.low time <= 0 && not (reaches_beyond w time)

let next q w p =
  let now test = match p.elapsed with None -> None | Some e -> Some (test w (Algebraic.of_rat e)) in
  if Positions.at q.g p.node && Option.value (now in_window) ~default:true then Goal
  else if (not (Positions.at q.f p.node)) || Option.value (now reaches_beyond) ~default:false then Fail
  else if not (q.graph.known p.node) then if q.generous then Goal else Fail
  else Go p

let limit : Timed_graph.flow -> Algebraic.t option = function
  | Lasts (d, _) -> Some (Algebraic.of_rat d)
  | No_flow | Forever -> None

(* g along the flow of a place, as far as that is in the window. *)
let goal_along q w p flow =
  let g = Positions.along q.g p.node in
  match p.elapsed with
  | None -> g
  | Some e ->
    let since = Algebraic.add_rat (Rat.neg e) in
    let within = Pieces.build ~limit:(limit flow) (since w.low :: Option.to_list (Option.map since w.high)) in
    Pieces.map2 ( && ) g (within (fun offset -> in_window w (Algebraic.add_rat e offset)))

let one way next = [ { way; next; probability = Rat.one } ]

(* What comes of letting time pass: each is a choice. *)
let by_flow q w p (flow : Timed_graph.flow) first =
  match (first, flow) with
  | Flow.Reached moment, _ -> [ one (During moment) Goal ]
  | Lost _, _ | Passes, (No_flow | Forever) -> [ one Nowhere Fail ]
  | Passes, Lasts (d, targets) ->
    List.mapi (fun k t -> one (Move (Flow k)) (next q w (after w p t d))) (Array.to_list targets)

let by_edges q w p =
  let branch k t probability = { way = Move (Edge k); next = next q w (after w p t Rat.zero); probability } in
  let edges = q.graph.edges p.node in
  match q.graph.drawn p.node with
  | Some chances -> [ List.mapi (fun k t -> branch k t chances.(k)) (Array.to_list edges) ]
  | None -> List.mapi (fun k t -> [ branch k t Rat.one ]) (Array.to_list edges)

let choices q w p =
  let flow = q.graph.flow p.node in
  let timed =
    match flow with
    | No_flow -> []
    | Lasts _ | Forever ->
      by_flow q w p flow (Flow.entering ~f:(Positions.along q.f p.node) ~g:(goal_along q w p flow))
  in
  match by_edges q w p @ timed with [] -> [ one Nowhere Fail ] | choices -> choices

let is_unbounded q = Rat.sign q.bound.low <= 0 && Option.is_none q.bound.high

let window q = { low = Algebraic.of_rat q.bound.low; high = Option.map Algebraic.of_rat q.bound.high }

(* What can come next at a position, with the window as it is seen from the node of its flow. *)
let from q (position : Positions.position) =
  let w = window q in
  let s = position.node in
  if not (Positions.is_inside position) then (w, [ one Nowhere (next q w (place w s Rat.zero)) ])
  else
    let later t = Algebraic.add_rat t position.offset in
    let w =
      if is_unbounded q then w else { low = later q.bound.low; high = Option.map later q.bound.high }
    in
    let p = { node = s; elapsed = (if is_unbounded q then None else Some Rat.zero) } in
    let flow = Timed_graph.flow q.graph s in
    (w, by_flow q w p flow (Flow.from ~f:(Positions.along q.f s) ~g:(goal_along q w p flow) position.offset))

(* {1 Solving} *)

type process = {
  question : question;
  seen_from : window;
  numbers : int Places.t;
  places : place Growable.t;
  solution : Solution.t;
}

let goal = 0
let fail = 1

(* The places that can be reached, numbered from 2 on in the order in which they are found, which is that in which
   they are looked at. *)
let build q w starts =
  let numbers = Places.create 1024 and places = Growable.create () in
  let number = function
    | Goal -> goal
    | Fail -> fail
    | Go p -> (
        match Places.find_opt numbers p with
        | Some n -> n
        | None ->
          let n = Growable.length places + 2 in
          Places.add numbers p n;
          Growable.push places p;
          n)
  in
  let builder = Mdp.builder () in
  let add_choice branches = Mdp.add_choice builder (List.map (fun b -> (number b.next, b.probability)) branches) in
  let ending = function Goal -> goal | Fail | Go _ -> fail in
  List.iter
    (fun e ->
       ignore (Mdp.add_state builder);
       Mdp.add_choice builder [ (ending e, Rat.one) ])
    [ Goal; Fail ];
  let asked = List.map number starts in
  let rec look i =
    if i < Growable.length places then begin
      ignore (Mdp.add_state builder);
      List.iter add_choice (choices q w (Growable.get places i));
      look (i + 1)
    end
  in
  look 0;
  match Mdp.finish builder with
  | Ok mdp -> (mdp, numbers, places, asked)
  | Error e -> Scc_base.Bug.fail __POS__ (Mdp.describe e)

let direction (side : Formula.side) : Equations.direction =
  match side with Least -> Min | Greatest -> Max

let solve q effort w starts =
  let mdp, numbers, places, asked = build q w starts in
  let until =
    Qualitative.until (Backwards.make mdp) ~stay:(fun s -> not (Int.equal s fail)) ~goal:(Int.equal goal)
  in
  let solution = Reach.solve until (direction q.side) effort ~asked:(States asked) in
  { question = q; seen_from = w; numbers; places; solution }

let number process = function
  | Goal -> goal
  | Fail -> fail
  | Go p -> Places.find process.numbers p

let value process next = Solution.value process.solution (number process next)

let best (side : Formula.side) answers =
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
  let limit =
    match (p.elapsed, w.high) with
    | Some e, Some h -> Some (Algebraic.add_rat (Rat.neg e) h)
    | None, _ | _, None -> None
  in
  Run.during q.graph ~f:q.f ~g:q.g ?limit p.node moment

let start_of w (position : Positions.position) = place w position.node Rat.zero

type trail = { source : place; branch : branch }

let to_run q w position trail : Run.t * Rat.t =
  let step t = match t.branch.way with Move move -> Some { Run.source = t.source.node; move } | _ -> None in
  let chance = List.fold_left (fun product t -> Rat.mul product t.branch.probability) Rat.one trail in
  let finish, last =
    match trail with
    | { source; branch = { way = During moment; _ } } :: _ -> (finish q w source moment, source.node)
    | { source; branch = { way = Move move; _ } } :: _ -> (Run.At_state, Timed_graph.target q.graph source.node move)
    | _ -> (Run.At_state, position.Positions.node)
  in
  ({ start = position; steps = List.filter_map step (List.rev trail); last; finish }, chance)

(* Those of the choices that a position begins with which attain what is best. *)
let first_choice process = function
  | [ only ] -> only
  | several ->
    let answer branches = List.map (fun b -> value process b.next) branches in
    let wanted = best process.question.side (List.concat_map answer several) in
    let same (a : Answer.t) = match (a, wanted) with Exact x, Exact y -> Rat.equal x y | _ -> false in
    Option.value (List.find_opt (fun c -> List.exists same (answer c)) several) ~default:[]

(* Breadth first through what the scheduler chooses. *)
let run q effort position =
  let w, first = from q position in
  let process = solve q effort w (nexts first) in
  let scheduler = Solution.scheduler process.solution in
  let found = Bits.create (Growable.length process.places + 2) and waiting = Queue.create () in
  let enter trail source branch =
    let n = number process branch.next in
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
      List.iter (enter trail p) (List.nth (choices q w p) scheduler.(Places.find process.numbers p));
      go ()
  in
  go ()
