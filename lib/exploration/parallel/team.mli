(** The processes of a {!Crew}, what they have been asked for, and how this process waits for them. *)

open Scc_graph_search

module Make (L : Lts.S) (Graph : module type of Explore.Make (L)) : sig
  module Service : module type of Served.Make (L) (Graph)

  type worker = {
    channel : Channel.t;
    bells : Served.bells;
    slots : Served.slot array;
    live : request Queue.t;  (** those that have a slot, in order *)
    mutable beyond : int;  (** the number of the next request; it has the slot of this number, by turns *)
    mutable under_way : request list;  (** in order *)
    mutable words : int;  (** of memory that it takes, as it last told *)
  }

  and request = {
    worker : worker option;  (** [None]: it is this process *)
    slot : Served.slot;
    mutable states : int array;  (** increasing *)
    mutable answered : int;  (** the first ones, which have been seen to; -1 while it is under way *)
    mutable next : int;  (** of those before it, the answers are of no use any more *)
  }

  type t = {
    shared : Service.shared;
    balance : Balance.t;
    jobs : int;
    waits : int -> bool;
    room : unit -> int;  (** how many states there may come to be *)
    requests : request Queue.t;  (** whose answers may be of use, in the order of their states *)
    mutable own_slots : Served.slot list;  (** those of no request *)
    mutable now : int;  (** the state whose turn it is *)
    mutable unasked : int;  (** the first state that is in no request so far *)
    mutable size : int;  (** of the graph, at the turn before *)
    mutable fresh : float;  (** how many states are new to a turn: a mean of the last ones *)
    mutable patience : float;  (** seconds to wait before it finds more ahead *)
    mutable is_ahead : bool;  (** this process finds what may be of use later *)
    mutable workers : worker list;
    mutable deaths : int;
  }

  (** {1 Workers} *)

  val make_slots : int -> Served.slot list option
  (** [make_slots count] is so many slots; [None] if the system gives no memory. *)

  val new_worker : t -> unit
  (** [new_worker c] forks one more worker, if the system gives memory and a process. *)

  val end_worker : t -> worker -> unit
  (** [end_worker c w] ends a worker. What it was to find is found in this process. *)

  val wake : t -> worker -> unit
  (** [wake c w] is called once something was written for a worker, which may wait for it. *)

  val collect : t -> unit
  (** [collect c] notes which requests are not under way any more. *)

  (** {1 Waiting} *)

  val wait_while : ?seconds:float -> t -> (unit -> bool) -> unit
  (** [wait_while c goes_on] waits until a worker has told something or died, if [goes_on ()] is still true once
      all workers know that this process waits; for 0.2 seconds at most, or [seconds] if these are fewer. *)

  val wait : ?seconds:float -> t -> request -> int -> unit
  (** [wait c r k] is the same while a worker is at the [k]-th state of a request. *)
end
