open Scc_ctl
open Scc_data
open Scc_exact
open Scc_evaluate
open Scc_verify

type status = Moves | Rests | Stuck | Unexplored
type stretch = {
  attained : bool;
  holds : bool array;
  lasts : Rat.t option;
  target : int;
  source : int;
}

type t = {
  space : Explored.t;
  predicates : State_predicates.t array;
  bits : Bits.t;  (** of each predicate that holds at a state, at the start of what follows it *)
  statuses : Bytes.t;
  stretches : stretch array;
  detours : (int, Rat.t * int) Hashtbl.t;
  changes : int array;
  undecided : (int * string) option array;
  inexact : int;
}

(** {2 States} *)

let duration (e : Explored.edge) =
  match e.label with
  | Time d -> Some d
  | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ -> None

(* At most one transition of a state is a passing of time. *)
let passing edges =
  let rec from k =
    if k = Array.length edges then None
    else
      match duration edges.(k) with
      | Some d -> Some (d, edges.(k).target)
      | None -> from (k + 1)
  in
  from 0

let status_of (space : Explored.t) i edges =
  if not (space.expanded i) then Unexplored
  else if Array.length edges > 0 then Moves
  else if space.rests i then Rests
  else Stuck

let char_of = function Moves -> 'm' | Rests -> 'r' | Stuck -> 's' | Unexplored -> 'u'

let status l i =
  match Bytes.get l.statuses i with
  | 'm' -> Moves
  | 'r' -> Rests
  | 's' -> Stuck
  | _ -> Unexplored

(** {2 Along a passing of time} *)

let constant (tl : bool Timeline.t) =
  match tl.rest with [] -> Bool.equal tl.start tl.first | _ :: _ -> false

(* Values of all predicates along the time, the last predicate first. *)
let together timelines =
  match timelines with
  | [] -> None
  | t :: rest ->
    let add all t = Timeline.map2 (fun values v -> v :: values) all t in
    Some
      (List.fold_left add (Timeline.map (fun v -> [ v ]) t) rest
       |> Timeline.simplify (List.equal Bool.equal))

let precision = Rat.make Z.one (Z.pow (Z.of_int 10) 12)

(* The instants after the start at which something changes, with what holds from then on. *)
let turns (tl : bool list Timeline.t) =
  let add attained (last, found) (offset, values) =
    if List.equal Bool.equal last values then (last, found)
    else (values, (offset, attained, values) :: found)
  in
  let piece acc (p : bool list Timeline.piece) =
    add false (add true acc (p.cut, p.at)) (p.cut, p.after)
  in
  let acc = add false (tl.start, []) (Algebraic.zero, tl.first) in
  List.rev (snd (List.fold_left piece acc tl.rest))

type builder = {
  mutable made : stretch list;  (** newest first *)
  mutable number : int;  (** of the next one *)
  mutable rounded : int;
}

let offset b earliest a =
  match Algebraic.to_rat a with
  | Some r -> r
  | None ->
    b.rounded <- b.rounded + 1;
    (* Of two instants that are closer than that, the later one does not come first. *)
    Rat.max earliest (fst (Algebraic.enclose a ~width:precision))

(* The chain for the passing of time from [source] that ends after [total] (never, when [None]) in [target]. *)
let chain b tl ~source ~total ~target =
  let place (earliest, found) (a, attained, values) =
    let at = offset b earliest a in
    (at, (at, attained, Array.of_list (List.rev values)) :: found)
  in
  let _, placed = List.fold_left place (Rat.zero, []) (turns tl) in
  let rec make = function
    | [] -> ()
    | (at, attained, holds) :: later ->
      let number = b.number in
      b.number <- number + 1;
      let lasts, target =
        match (later, total) with
        | (next, _, _) :: _, _ -> (Some (Rat.sub next at), number + 1)
        | [], Some d -> (Some (Rat.sub d at), target)
        | [], None -> (None, number)
      in
      b.made <- { attained; holds; lasts; target; source } :: b.made;
      make later
  in
  match List.rev placed with
  | [] -> None
  | (first, _, _) :: _ as placed ->
    let number = b.number in
    make placed;
    Some (first, number)

(** {2 The whole graph} *)

let make ?(instants = false) (space : Explored.t) predicates =
  let n = Array.length predicates in
  let bits = Bits.create (space.size * n) in
  let statuses = Bytes.make space.size 'u' in
  let detours = Hashtbl.create 16 in
  let changes = Array.make n 0 and undecided = Array.make n None in
  let b = { made = []; number = space.size; rounded = 0 } in
  let truth i k : Truth.t -> bool = function
    | True -> true
    | False -> false
    | Undecided why ->
      if Option.is_none undecided.(k) then undecided.(k) <- Some (i, why);
      false
  in
  let timeline i trajectory k (p : State_predicates.t) =
    let tl =
      Timeline.map (truth i k) (Trajectory.prop trajectory p.prop) |> Timeline.simplify Bool.equal
    in
    if tl.start then Bits.add bits ((i * n) + k);
    if not (constant tl) then changes.(k) <- changes.(k) + 1;
    tl
  in
  let visit i =
    let edges = space.edges i in
    let status = status_of space i edges in
    Bytes.set statuses i (char_of status);
    let extent, way =
      match (status, passing edges) with
      | Rests, _ -> (Timeline.Forever, Some (None, i))
      | _, Some (d, target) -> (Timeline.Lasts d, Some (Some d, target))
      | _, None -> (Timeline.Instant, None)
    in
    if n > 0 then begin
      let trajectory = Trajectory.make space.semantics (space.state i) extent in
      let timelines = List.mapi (timeline i trajectory) (Array.to_list predicates) in
      match (way, together timelines) with
      | Some (total, target), Some tl when instants -> (
          match chain b tl ~source:i ~total ~target with
          | None -> ()
          | Some detour -> Hashtbl.replace detours i detour)
      | _, _ -> ()
    end
  in
  for i = 0 to space.size - 1 do
    visit i
  done;
  {
    space;
    predicates;
    bits;
    statuses;
    stretches = Array.of_list (List.rev b.made);
    detours;
    changes;
    undecided;
    inexact = b.rounded;
  }

let space l = l.space
let predicates l = l.predicates
let size l = l.space.size + Array.length l.stretches
let stretch l i = if i < l.space.size then None else Some l.stretches.(i - l.space.size)
let detour l i = Hashtbl.find_opt l.detours i

let holds l i k =
  match stretch l i with
  | None -> Bits.mem l.bits ((i * Array.length l.predicates) + k)
  | Some s -> s.holds.(k)

let changes l k = l.changes.(k)
let undecided l k = l.undecided.(k)
let inexact l = l.inexact

let count l wanted =
  let c = char_of wanted in
  let rec from i n =
    if i = Bytes.length l.statuses then n
    else from (i + 1) (if Char.equal (Bytes.get l.statuses i) c then n + 1 else n)
  in
  from 0 0
