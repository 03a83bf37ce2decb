open Scc_data
open Scc_exact

type position = int

(* A place on the way of a passing of time: where it leads, and how long that takes from here. *)
type way = To of { target : position; rest : Rat.t } | Rest

type t = {
  graph : Graph.t;
  passings : Label.passing option array;  (* of each label; none in an untimed system *)
  ways : way Growable.t;  (* positions from [graph.size] on *)
  closures : (position, position list) Hashtbl.t;
  mutable remembered : int;  (* how many positions are in these *)
  numbers : (int * string, position) Hashtbl.t;
  (* of target and the text of the rest; (-1, "") for [Rest] *)
}

let make graph passings =
  {
    graph;
    passings;
    ways = Growable.create ();
    closures = Hashtbl.create 16;
    remembered = 0;
    numbers = Hashtbl.create 16;
  }
let untimed (g : Graph.t) = make g (Array.map (fun _ -> None) g.labels)
let timed (g : Graph.t) = make g (Array.map Label.passing g.labels)
let graph m = m.graph
let is_state m p = p < m.graph.size
let known m p = (not (is_state m p)) || Graph.known m.graph p

let actions m p f =
  if is_state m p then
    Graph.iter m.graph p (fun label target ->
        match m.passings.(label) with None -> f label target | Some _ -> ())

let after m p action =
  let found = ref [] in
  actions m p (fun label target -> if label = action then found := target :: !found);
  List.rev !found

let closure_of_all m positions =
  let seen = Hashtbl.create 16 in
  let rec visit found = function
    | [] -> List.rev found
    | p :: rest when Hashtbl.mem seen p -> visit found rest
    | p :: rest ->
      Hashtbl.add seen p ();
      visit (p :: found) (List.rev_append (List.rev (after m p 0)) rest)
  in
  visit [] positions

(* Games ask for the closures of the same positions again and again. *)
let most_remembered = 4_000_000

let closure_of m p =
  match Hashtbl.find_opt m.closures p with
  | Some closure -> closure
  | None ->
    let closure = closure_of_all m [ p ] in
    let n = List.length closure in
    if m.remembered + n <= most_remembered then begin
      m.remembered <- m.remembered + n;
      Hashtbl.add m.closures p closure
    end;
    closure

let silent_closure m = function
  | [ p ] -> closure_of m p
  | positions -> closure_of_all m positions

type patience = Never | For of Rat.t | Forever

let passings_of m p =
  let found = ref [] in
  Graph.iter m.graph p (fun label target ->
      match m.passings.(label) with
      | Some passing -> found := (passing, target) :: !found
      | None -> ());
  List.rev !found

let shorter a b =
  match (a, b) with
  | Never, p | p, Never -> p
  | Forever, p | p, Forever -> p
  | For a, For b -> For (Rat.min a b)

let patience m p =
  if is_state m p then
    List.fold_left
      (fun least (passing, _) ->
         shorter least (match passing with Label.For d -> For d | Label.Forever -> Forever))
      Never (passings_of m p)
  else match Growable.get m.ways (p - m.graph.size) with To { rest; _ } -> For rest | Rest -> Forever

let common a b =
  match shorter a b with Never -> None | For d -> Some d | Forever -> Some Rat.one

let number m key way =
  match Hashtbl.find_opt m.numbers key with
  | Some p -> p
  | None ->
    let p = m.graph.size + Growable.length m.ways in
    Growable.push m.ways way;
    Hashtbl.add m.numbers key p;
    p

let place m target rest = number m (target, Rat.to_string rest) (To { target; rest })
let rest m = number m (-1, "") Rest

(* Along one passing of time: where it is after [d], and how much of [d] is left once it is over. *)
let along m target length d =
  let c = Rat.compare length d in
  if c > 0 then (place m target (Rat.sub length d), Rat.zero) else (target, Rat.sub d length)

let ways_from m p d =
  if is_state m p then
    List.map
      (fun (passing, target) ->
         match passing with
         | Label.Forever -> (rest m, Rat.zero)
         | Label.For length -> along m target length d)
      (passings_of m p)
  else
    match Growable.get m.ways (p - m.graph.size) with
    | To { target; rest } -> [ along m target rest d ]
    | Rest -> [ (p, Rat.zero) ]

(* Where all waits of [d] end, and whether one of them meets an unknown state before that. *)
let waits m p d =
  let rec go ends unknown seen = function
    | [] -> (List.rev ends, unknown)
    | (p, d) :: rest when Rat.sign d = 0 ->
      go (if List.mem p ends then ends else p :: ends) unknown seen rest
    | (p, d) :: rest when List.exists (fun (q, e) -> q = p && Rat.equal d e) seen -> go ends unknown seen rest
    | (p, d) :: rest ->
      go ends (unknown || not (known m p)) ((p, d) :: seen) (List.rev_append (ways_from m p d) rest)
  in
  go [] false [] [ (p, d) ]

let wait m p d = fst (waits m p d)
let stuck_waiting m p d = snd (waits m p d)
