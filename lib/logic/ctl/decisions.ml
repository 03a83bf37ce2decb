open Scc_data
open Scc_exact
open Scc_chance

type question = {
  graph : Timed_graph.t;
  side : Timed_formula.side;
  bound : Timed_formula.bound;
  f : Positions.t;
  g : Positions.t;
  generous : bool;
}

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

type branch = { way : way; next : next; probability : Rat.t; reward : Rat.t }

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

let one ?(reward = Rat.zero) way next = [ { way; next; probability = Rat.one; reward } ]

(* What comes of letting time pass: each is a choice. *)
let by_flow q w p (flow : Timed_graph.flow) first =
  match (first, flow) with
  | Flow.Reached moment, _ -> [ one (During moment) Goal ]
  | Lost _, _ | Passes, (No_flow | Forever) -> [ one Nowhere Fail ]
  | Passes, Lasts (d, targets) ->
    List.mapi (fun k t -> one (Move (Flow k)) (next q w (after w p t d))) (Array.to_list targets)

let by_edges q w p =
  let branch (k, t, probability) =
    { way = Move (Edge k); next = next q w (after w p t Rat.zero); probability; reward = Rat.zero }
  in
  List.map (List.map branch) (Timed_graph.edge_choices q.graph p.node)

let choices q w p =
  let flow = q.graph.flow p.node in
  let timed =
    match flow with
    | No_flow -> []
    | Lasts _ | Forever ->
      by_flow q w p flow (Flow.entering ~f:(Positions.along q.f p.node) ~g:(goal_along q w p flow))
  in
  match by_edges q w p @ timed with [] -> [ one Nowhere Fail ] | choices -> choices

let meetings q w p =
  let meeting b : Timeline.moment option =
    match (b.next, b.way) with
    | (Fail | Go _), _ | Goal, Nowhere -> None
    | Goal, During moment -> Some moment
    | Goal, Move move ->
      Some { offset = Algebraic.of_rat (Timed_graph.duration q.graph p.node move); attained = true }
  in
  List.filter_map meeting (List.concat (choices q w p))

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

(* {1 As a process with numbers for its states} *)

type built = { mdp : Mdp.t; numbers : int Places.t; places : place Growable.t; asked : int list }

let goal = 0
let fail = 1

(* The places that can be reached, numbered from 2 on in the order in which they are found, which is that in which
   they are looked at. *)
let build ~choices starts =
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
  let earned sum b = Rat.add sum (Rat.mul b.probability b.reward) in
  let add_choice branches =
    Mdp.add_choice builder
      ~reward:(List.fold_left earned Rat.zero branches)
      (List.map (fun b -> (number b.next, b.probability)) branches)
  in
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
      List.iter add_choice (choices (Growable.get places i));
      look (i + 1)
    end
  in
  look 0;
  match Mdp.finish builder with
  | Ok mdp -> { mdp; numbers; places; asked }
  | Error e -> Scc_base.Bug.fail __POS__ (Mdp.describe e)


let number built = function
  | Goal -> goal
  | Fail -> fail
  | Go p -> Places.find built.numbers p

let until built =
  Qualitative.until (Backwards.make built.mdp)
    ~stay:(fun s -> not (Int.equal s fail))
    ~goal:(Int.equal goal)

let same_process a b =
  let same_place n =
    let p = Growable.get a.places n and q = Growable.get b.places n in
    Int.equal p.node q.node && Option.equal Rat.equal p.elapsed q.elapsed
  in
  let rec all n test = n = 0 || (test (n - 1) && all (n - 1) test) in
  List.equal Int.equal a.asked b.asked
  && Growable.length a.places = Growable.length b.places
  && all (Growable.length a.places) same_place
  && Mdp.equal a.mdp b.mdp

let direction (side : Timed_formula.side) : Equations.direction =
  match side with Least -> Min | Greatest -> Max
