open Scc_exact
open Recorded

type side = First | Second

type t =
  | Header of { what : string; first : string; second : string }
  | Event of { number : int; first : item; second : item; what : event_difference }
  | More of { side : side; number : int; item : item }
  | State of {
      first : item;
      second : item;
      events : int;
      body : string;
      quantity : string;
      told : string * string;
      off : Rat.t option;
    }
  | Ending of { first : string; second : string }

and event_difference =
  | Label
  | Time of Rat.t
  | Choice of int * int
  | Rules of string list * string list

let first_some attempts = List.find_map (fun attempt -> attempt ()) attempts
let close ~tolerance a b = Rat.compare (Rat.abs (Rat.sub a b)) tolerance <= 0

(* {1 Headers} *)

let header (a : Recorded.t) (b : Recorded.t) =
  let digest () =
    match (a.digest, b.digest) with
    | Some (first, _), Some (second, _) when not (String.equal first second) ->
      Some (Header { what = "digest"; first; second })
    | _ -> None
  in
  let parameter (name, value) =
    match List.assoc_opt name b.parameters with
    | Some other when not (Rat.equal value other) ->
      Some
        (Header { what = "parameter " ^ name; first = Rat.to_string value; second = Rat.to_string other })
    | Some _ | None -> None
  in
  first_some [ (fun () -> List.find_map parameter a.parameters); digest ]

(* {1 Events} *)

(* What one of the two does not tell is no difference. *)
let agree equal a b = a = [] || b = [] || equal a b
let same_texts = List.equal String.equal

(* The same bodies, also where features alone name them: with a dot after them, and perhaps a part of the body. *)
let same_owners (a : event) (b : event) =
  let owns body feature =
    let n = String.length body in
    String.length feature > n && String.equal (String.sub feature 0 (n + 1)) (body ^ ".")
  in
  let fit bodies features =
    List.for_all (fun b -> List.exists (owns b) features) bodies
    && List.for_all (fun f -> List.exists (fun b -> owns b f) bodies) features
  in
  match (a.bodies, b.bodies) with
  | _ :: _, _ :: _ ->
    same_texts (List.sort_uniq String.compare a.bodies) (List.sort_uniq String.compare b.bodies)
  | _ :: _, [] -> fit a.bodies b.features
  | [], _ :: _ -> fit b.bodies a.features
  | [], [] -> true

let same_event (a : event) (b : event) =
  a.kind = b.kind
  && agree same_texts a.channels b.channels
  && agree same_texts a.features b.features
  && (a.channels = [] || b.channels = [] || agree same_texts a.together b.together)
  && (a.features <> [] && b.features <> [] || same_owners a b)

let event ~tolerance number ((first : item), e) ((second : item), e') =
  let told what = Some (Event { number; first; second; what }) in
  if not (same_event e e') then told Label
  else if not (close ~tolerance first.time second.time) then told (Time (Rat.sub second.time first.time))
  else
    match (first.choice, second.choice) with
    | Some { number = Some m; _ }, Some { number = Some n; _ } when m <> n -> told (Choice (m, n))
    | Some { rules = Some r; _ }, Some { rules = Some s; _ } when not (same_texts r s) -> told (Rules (r, s))
    | _ -> None

(* {1 States} *)

type told = { quantity : string; value : string; number : Rat.t option }

let facts (b : body) =
  let text quantity value = { quantity; value; number = None } in
  let number quantity q = { quantity; value = Rat.to_string q; number = Some q } in
  let list quantity = Option.map (fun l -> text quantity ("{" ^ String.concat ", " l ^ "}")) in
  let show = Option.value ~default:"none" in
  let clock =
    Option.map (function Some c -> number "clock" c | None -> text "clock" "none") b.clock
  in
  let turned =
    Option.map (fun (w, v) -> text "turned" (Rat.to_string w ^ " " ^ Vec.to_string v)) b.turned
  in
  Option.to_list (list "process" b.group)
  @ Option.to_list (list "bonds" b.bonds)
  @ List.map (fun (q, value) -> number (quantity_text q) value) b.numbers
  @ Option.to_list turned
  @ Option.to_list (Option.map (text "behaviour") b.behaviour)
  @ Option.to_list (Option.map (fun o -> text "origin" (show o)) b.origin)
  @ Option.to_list clock

let same_fact ~tolerance a b =
  match (a.number, b.number) with
  | Some x, Some y -> close ~tolerance x y
  | _ ->
    (* quaternions of float traces are left to their velocities *)
    String.equal a.value b.value || (String.equal a.quantity "turned" && Rat.sign tolerance > 0)

let state ~tolerance ~events bodies others =
  let fact name first second other a =
    match List.find_opt (fun f -> String.equal f.quantity a.quantity) other with
    | Some b when not (same_fact ~tolerance a b) ->
      let off = match (a.number, b.number) with Some x, Some y -> Some (Rat.sub y x) | _ -> None in
      Some (State { first; second; events; body = name; quantity = a.quantity; told = (a.value, b.value); off })
    | Some _ | None -> None
  in
  let by_name = Hashtbl.create 16 in
  List.iter (fun (second, (o : body)) -> Hashtbl.replace by_name o.name (second, o)) others;
  let body (first, (b : body)) =
    match Hashtbl.find_opt by_name b.name with
    | Some (second, other) ->
      let other = facts other in
      List.find_map (fact b.name first second other) (facts b)
    | None -> None
  in
  List.find_map body bodies

(* {1 Both} *)

(* A trace cut into its events, each with the states told after it and before the next one. A state may be told
   body by body. *)
type state = { time : Rat.t; bodies : (item * body) list }
type piece = { event : (item * event) option; states : state list }

(* What is told of a body at that time a second time, with no event between, begins a new state. *)
let add_state (i : item) bodies states =
  let mine = List.rev_map (fun b -> (i, b)) bodies in
  match (states, bodies) with
  | s :: rest, [ (b : body) ]
    when Rat.equal s.time i.time && not (List.exists (fun (_, (o : body)) -> String.equal b.name o.name) s.bodies)
    -> { s with bodies = mine @ s.bodies } :: rest
  | _ -> { time = i.time; bodies = mine } :: states

let pieces (t : Recorded.t) =
  let in_order s = { s with bodies = List.rev s.bodies } in
  let close_piece p = { p with states = List.rev_map in_order p.states } in
  let add (done_, now) (i : item) =
    match i.what with
    | Event e -> (close_piece now :: done_, { event = Some (i, e); states = [] })
    | State ((_ :: _ as bodies), _) -> (done_, { now with states = add_state i bodies now.states })
    | State ([], _) | Watched | Quiescent | Stuck -> (done_, now)
  in
  let done_, last = Array.fold_left add ([], { event = None; states = [] }) t.items in
  List.rev (close_piece last :: done_)

(* States of the same time, in their order. *)
let rec states ~tolerance ~events a b =
  match (a, b) with
  | [], _ | _, [] -> None
  | i :: a', j :: b' -> (
      if close ~tolerance i.time j.time then
        match state ~tolerance ~events i.bodies j.bodies with
        | Some d -> Some d
        | None -> states ~tolerance ~events a' b'
      else if Rat.compare i.time j.time < 0 then states ~tolerance ~events a' b
      else states ~tolerance ~events a b')

let claim (t : Recorded.t) =
  let named (i : item) = match i.what with Quiescent -> Some "quiescent" | Stuck -> Some "stuck" | _ -> None in
  Array.fold_left (fun found i -> match named i with Some n -> Some n | None -> found) None t.items

let ending a b =
  match (claim a, claim b) with
  | Some first, Some second when not (String.equal first second) -> Some (Ending { first; second })
  | _ -> None

let find a b ~tolerance =
  let rec compare number ps qs =
    match (ps, qs) with
    | [], [] -> ending a b
    | { event = Some (item, _); _ } :: _, [] -> Some (More { side = First; number; item })
    | [], { event = Some (item, _); _ } :: _ -> Some (More { side = Second; number; item })
    | { event = None; _ } :: _, [] | [], { event = None; _ } :: _ -> None
    | p :: ps, q :: qs -> (
        let events =
          match (p.event, q.event) with
          | Some x, Some y -> event ~tolerance number x y
          | _ -> None
        in
        match events with
        | Some d -> Some d
        | None -> (
            match states ~tolerance ~events:number p.states q.states with
            | Some d -> Some d
            | None -> compare (number + 1) ps qs))
  in
  match header a b with Some d -> Some d | None -> compare 0 (pieces a) (pieces b)
