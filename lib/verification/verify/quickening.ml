open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_state_space
module Graph = State_graph

type t = { factor : Rat.t; until : Rat.t }

(** {2 Laws} *)

(* How an expression grows with the velocity: by a power of the factor, or not at all by one (0 by any). *)
type growth = Any | Power of int | Other

let alike a b =
  match (a, b) with
  | Any, g | g, Any -> g
  | Power m, Power n when m = n -> Power m
  | (Power _ | Other), _ -> Other

let combine f a b =
  match (a, b) with
  | Power m, Power n -> Power (f m n)
  | (Any | Power _ | Other), _ -> Other

let rec growth (e : Law.expr) =
  match e with
  | Const r | Open { value = r; _ } -> if Rat.sign r = 0 then Any else Power 0
  | Var (Vx | Vy | Vz) -> Power 1
  | Var Mass -> Power 0
  | Var (X | Y | Z | Wx | Wy | Wz | Time | Dt) | Round _ -> Other
  | Neg a -> growth a
  | Add (a, b) | Sub (a, b) -> alike (growth a) (growth b)
  | Mul (a, b) -> combine ( + ) (growth a) (growth b)
  | Div (a, b) -> combine ( - ) (growth a) (growth b)
  | If (c, a, b) -> if same_for_all c then alike (growth a) (growth b) else Other

(* What does not depend on how fast all is. *)
and same_for_all (c : Law.cond) =
  match c with
  | Bool _ -> true
  | Compare (_, a, b) -> ( match alike (growth a) (growth b) with Any | Power _ -> true | Other -> false)
  | And (a, b) | Or (a, b) -> same_for_all a && same_for_all b
  | Not a -> same_for_all a

let linear (law : Law.t) =
  let is_linear e = match alike (growth e) (Power 1) with Power 1 -> true | Any | Power _ | Other -> false in
  match law with
  | Inertial -> true
  | Gives { velocity = x, y, z; spin = None } -> is_linear x && is_linear y && is_linear z
  | Gives { spin = Some _; _ } | Choose _ -> false

let may_quicken (m : Model.t) =
  Model.of_all m
  && (not (Model.keeps_beat m))
  && not (Model.has_turns m)
  && Array.for_all (fun (l : Model.leaf) -> linear l.law) m.leaves

(** {2 Rounds} *)

let ratio (v : Vec.t) (w : Vec.t) =
  let pairs = [ (v.x, w.x); (v.y, w.y); (v.z, w.z) ] in
  List.find_map (fun (a, b) -> if Rat.sign a = 0 then None else Some (Rat.div b a)) pairs

(* By which factor the one state is the other, but faster; all else is the same, the movement step too. *)
let factor (s : State.t) (t : State.t) =
  let n = Array.length s.processes in
  let at_rest p = State.with_velocity Vec.zero p in
  let same p q = State.equal_process (at_rest p) (at_rest q) in
  let same_step =
    Option.equal
      (fun (a : State.step) (b : State.step) ->
         Rat.equal a.remaining b.remaining && a.phase = b.phase)
      s.step t.step
  in
  let alike = Array.length t.processes = n && same_step && Array.for_all2 same s.processes t.processes in
  if not alike then None
  else
    let velocities = List.init n (fun i -> (s.processes.(i).velocity, t.processes.(i).velocity)) in
    match List.find_map (fun (v, w) -> ratio v w) velocities with
    | Some k
      when Rat.compare k Rat.one > 0 && List.for_all (fun (v, w) -> Vec.equal (Vec.scale k v) w) velocities ->
      Some k
    | Some _ | None -> None

type way = Passes of Rat.t | Bounces | Otherwise

type place = { state : State.t; way : way  (** to it, from the place before it on the path *) }

let way context graph source target =
  let edges = Graph.edges graph source in
  match List.find_opt (fun (e : Graph.edge) -> e.target = target) (Array.to_list edges) with
  | None -> Otherwise
  | Some e -> (
      match Catalogue.single (Network_lts.catalogue context) e.label with
      | Some (Time d) -> Passes d
      | Some (Bounce _) -> Bounces
      | Some (Bind _ | Close _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _) | None -> Otherwise)

(* No eps, split or end of a step, which come at times of their own: after each passing of time there is a bounce.
   How long the round took, if so. [round] is the ways of it, in order; the places between are those of
   [inside]. *)
let took (m : Model.t) ~round ~inside =
  let timeless (s : State.t) = Array.for_all (fun p -> Option.is_none (Time.wait m p)) s.processes in
  let rec sum total = function
    | [] -> Some total
    | Bounces :: rest -> sum total rest
    | Passes d :: (Bounces :: _ as rest) -> sum (Rat.add total d) rest
    | (Passes _ | Otherwise) :: _ -> None
  in
  if List.for_all timeless inside then sum Rat.zero round else None

let farthest = 200

let rec last n = function
  | _ :: rest as list when List.compare_length_with list n > 0 -> last n rest
  | list -> list

(* From the last bounce back to one after which all was the same, but slower. *)
let of_places m arrival places =
  let rec back ~round ~inside target = function
    | [] -> None
    | p :: before -> (
        let further () = back ~round:(p.way :: round) ~inside:(p.state :: inside) target before in
        match (p.way, factor p.state target) with
        | Bounces, Some k -> (
            match took m ~round ~inside:(p.state :: inside) with
            | Some d when Rat.sign d > 0 ->
              Some { factor = k; until = Rat.add arrival (Rat.div d (Rat.sub k Rat.one)) }
            | Some _ | None -> further ())
        | (Bounces | Passes _ | Otherwise), _ -> further ())
  in
  match places with
  | { way = Bounces; state } :: before -> back ~round:[ Bounces ] ~inside:[] state before
  | _ -> None

let rec drop_to_bounce = function
  | ({ way = Passes _ | Otherwise; _ }, _) :: rest -> drop_to_bounce rest
  | list -> list

let find context graph =
  let m = Network_lts.model context in
  if not (may_quicken m) then None
  else
    let decode i = Catalogue.decode (Network_lts.catalogue context) (Graph.tuple graph i) in
    let rec places newest = function
      | source :: (target :: _ as rest) ->
        places (({ state = decode target; way = way context graph source target }, target) :: newest) rest
      | [ _ ] | [] -> newest
    in
    let path = Option.fold ~none:[] ~some:(Graph.ancestors graph) (Slowing.deepest graph) in
    match drop_to_bounce (places [] (last farthest path)) with
    | [] -> None
    | (_, i) :: _ as all -> of_places m (Graph.arrival graph i) (List.map fst all)

let to_string q =
  Printf.sprintf "some run repeats itself %s times as fast each round, and its time does not pass %s"
    (Rat.to_string q.factor) (Rat.to_string q.until)
