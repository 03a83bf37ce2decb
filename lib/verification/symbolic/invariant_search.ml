open Scc_property
open Scc_state_sets
module Invariant = Scc_certificate.Invariant

type visitor = { stop : unit -> bool; looked_at : locations:int -> waiting:int -> unit }
type end_ = Found of Invariant.t | No_end of string | Stopped

module Kinds = Hashtbl.Make (struct
    type t = Zone.t

    let equal = Zone_form.same_kind
    let hash = Zone_form.hash_kind
  end)

(* All states of one kind that are known to be needed. *)
type kind = {
  number : int;
  mutable zone : Zone.t;  (** canonical *)
  mutable grown : int;  (** how often *)
  mutable queued : bool;
}

type search = {
  context : Instant.context;
  events : Property.event array;
  kinds : kind Kinds.t;
  by_number : kind Scc_data.Growable.t;
  waiting : kind Queue.t;
}

(* {1 Growing} *)

(* How often a zone grows before it is widened: what comes to rest by itself stays exact. *)
let patience = 4

let queue s k =
  if not k.queued then begin
    k.queued <- true;
    Queue.add k s.waiting
  end

let grow s zone =
  let zone, _ = Zone_form.canonical zone in
  match Kinds.find_opt s.kinds zone with
  | None ->
    let k = { number = Scc_data.Growable.length s.by_number; zone; grown = 0; queued = false } in
    Kinds.replace s.kinds zone k;
    Scc_data.Growable.push s.by_number k;
    queue s k
  | Some k ->
    if Option.is_none (Zone_form.included zone k.zone) then begin
      let joined = Zone_hull.join s.context k.zone zone in
      k.zone <- (if k.grown >= patience then Zone_hull.widen s.context k.zone joined else joined);
      k.grown <- k.grown + 1;
      queue s k
    end

let after s k =
  let of_zone zone = (Zone_steps.all s.context ~events:s.events zone).steps in
  List.map snd (List.concat_map of_zone (Plausible.pieces s.context k.zone))

let all s = List.init (Scc_data.Growable.length s.by_number) (Scc_data.Growable.get s.by_number)

(* {1 Narrowing} *)

let rounds = 2

(* What comes of an invariant, and what it starts from, is one as well, and lies in it. *)
let narrow s starts =
  let next = Array.make (Scc_data.Growable.length s.by_number) None in
  let add zone =
    let zone, _ = Zone_form.canonical zone in
    let k = Kinds.find s.kinds zone in
    let together others =
      if Option.is_some (Zone_form.included zone others) then others else Zone_hull.join s.context others zone
    in
    next.(k.number) <- Some (Option.fold ~none:zone ~some:together next.(k.number))
  in
  List.iter add starts;
  List.iter (fun k -> List.iter add (after s k)) (all s);
  let tighten k = Option.iter (fun zone -> k.zone <- Zone_hull.meet zone k.zone) next.(k.number) in
  List.iter tighten (all s)

let invariant s =
  let location k =
    if k.zone.halted then None
    else Some { Invariant.skeleton = k.zone.skeleton; arrived = k.zone.arrived; set = Zone_form.set_of k.zone }
  in
  { Invariant.events = s.events; locations = List.filter_map location (all s) }

let find context ~events ~most ~visitor starts =
  let s =
    {
      context;
      events;
      kinds = Kinds.create 64;
      by_number = Scc_data.Growable.create ();
      waiting = Queue.create ();
    }
  in
  let size () = Scc_data.Growable.length s.by_number in
  let rec go () =
    match Queue.take_opt s.waiting with
    | None ->
      for _ = 1 to rounds do
        narrow s starts
      done;
      Found (invariant s)
    | Some _ when visitor.stop () -> Stopped
    | Some _ when size () > most -> No_end (Printf.sprintf "there are more than %d kinds of states" most)
    | Some k ->
      visitor.looked_at ~locations:(size ()) ~waiting:(Queue.length s.waiting);
      k.queued <- false;
      List.iter (grow s) (after s k);
      go ()
  in
  match
    List.iter (grow s) starts;
    go ()
  with
  | end_ -> end_
  | exception Instant.Not_affine reason -> No_end reason
