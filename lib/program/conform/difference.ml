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
  | Ending of { first : item; second : item; quantity : string; told : string * string; off : Rat.t option }

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

let difference ~events first second body quantity told off =
  State { first; second; events; body; quantity; told; off }

(* The names that a trace has for bodies, wherever it has them. *)
let names (t : Recorded.t) =
  let known = Hashtbl.create 16 in
  let add name = Hashtbl.replace known name () in
  let of_item (i : item) =
    match i.what with
    | Event e -> List.iter add e.bodies
    | State (bodies, _) -> List.iter (fun (b : body) -> add b.name) bodies
    | Watched | Quiescent | Stuck -> ()
  in
  Array.iter of_item t.items;
  Hashtbl.mem known

(* A body that is told of in one state only is no difference, unless it is there under another name: each of the
   two tells of one that the other does not, and one of the names is never heard of in the other trace. *)
let renamed ~events ~known bodies others =
  let lacking all =
    let told = Hashtbl.create 16 in
    List.iter (fun (_, (b : body)) -> Hashtbl.replace told b.name ()) all;
    fun (_, (b : body)) -> not (Hashtbl.mem told b.name)
  in
  match (List.filter (lacking others) bodies, List.filter (lacking bodies) others) with
  | ((_ :: _) as only), ((_ :: _) as only') -> (
      let strange knows (_, (b : body)) = not (knows b.name) in
      let pair =
        match (List.find_opt (strange (snd known)) only, List.find_opt (strange (fst known)) only') with
        | None, None -> None
        | x, y -> Some (Option.value x ~default:(List.hd only), Option.value y ~default:(List.hd only'))
      in
      match pair with
      | Some ((first, x), (second, y)) ->
        Some (difference ~events first second x.name "name" (x.name, y.name) None)
      | None -> None)
  | _ -> None

let state ~tolerance ~events ~known bodies others =
  let fact name first second other a =
    match List.find_opt (fun f -> String.equal f.quantity a.quantity) other with
    | Some b when not (same_fact ~tolerance a b) ->
      let off = match (a.number, b.number) with Some x, Some y -> Some (Rat.sub y x) | _ -> None in
      Some (difference ~events first second name a.quantity (a.value, b.value) off)
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
  first_some [ (fun () -> renamed ~events ~known bodies others); (fun () -> List.find_map body bodies) ]

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
let rec states ~tolerance ~events ~known a b =
  match (a, b) with
  | [], _ | _, [] -> None
  | i :: a', j :: b' -> (
      if close ~tolerance i.time j.time then
        match state ~tolerance ~events ~known i.bodies j.bodies with
        | Some d -> Some d
        | None -> states ~tolerance ~events ~known a' b'
      else if Rat.compare i.time j.time < 0 then states ~tolerance ~events ~known a' b
      else states ~tolerance ~events ~known a b')

(* When a body is told of: as often in both, it is at the same times. *)
let times ~tolerance ~events a b =
  let told states =
    let by_name = Hashtbl.create 16 in
    let add (s : state) (i, (b : body)) =
      Hashtbl.replace by_name b.name ((s.time, i) :: Option.value (Hashtbl.find_opt by_name b.name) ~default:[])
    in
    List.iter (fun s -> List.iter (add s) s.bodies) (List.rev states);
    by_name
  in
  let others = told b and mine = told a in
  let of_body (_, (body : body)) =
    let told = Hashtbl.find_opt mine body.name in
    Hashtbl.remove mine body.name;
    match (told, Hashtbl.find_opt others body.name) with
    | Some l, Some l' when List.compare_lengths l l' = 0 ->
      let differs ((t, first), (t', second)) =
        if close ~tolerance t t' then None
        else
          let told = (Rat.to_string t, Rat.to_string t') in
          Some (difference ~events first second body.name "time" told (Some (Rat.sub t' t)))
      in
      List.find_map differs (List.combine l l')
    | _ -> None
  in
  List.find_map (fun s -> List.find_map of_body s.bodies) a

let ending ~tolerance (a : Recorded.t) (b : Recorded.t) =
  match (a.ending, b.ending) with
  | Some { last = first; claim }, Some { last = second; claim = claim' } -> (
      let differ quantity told off = Some (Ending { first; second; quantity; told; off }) in
      match (claim, claim') with
      | _ when not (close ~tolerance first.time second.time) ->
        let told = (Rat.to_string first.time, Rat.to_string second.time) in
        differ "time" told (Some (Rat.sub second.time first.time))
      | Some c, Some c' when not (String.equal c c') -> differ "claim" (c, c') None
      | _ -> None)
  | _ -> None

let find a b ~tolerance =
  let known = (names a, names b) in
  let rec compare number ps qs =
    match (ps, qs) with
    | [], [] -> ending ~tolerance a b
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
            match
              first_some
                [
                  (fun () -> times ~tolerance ~events:number p.states q.states);
                  (fun () -> states ~tolerance ~events:number ~known p.states q.states);
                ]
            with
            | Some d -> Some d
            | None -> compare (number + 1) ps qs))
  in
  match header a b with Some d -> Some d | None -> compare 0 (pieces a) (pieces b)
