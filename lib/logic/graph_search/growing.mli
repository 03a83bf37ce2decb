(** A graph that grows: new states, bounds, and what a new edge changes for states that are known. *)

open Scc_exact

module Make (L : Lts.S) : sig
  include module type of struct
    include Ahead.Make (L)
  end

  (** {1 How an exploration is followed and fed}

      {!Explore} explains these types. *)

  (** An edge of a state that is expanded: to a new state, or to one that is known by then. *)
  type arrow = New of Lts.step | Known of edge

  (** The transitions of a state; [reduced] if further ones are postponed. *)
  type steps = { steps : Lts.step list; reduced : bool }

  (** The edges of a state that change something, with the number of all of them. *)
  type noted = { arrows : arrow list; count : int; reduced : bool }

  (** The transitions of a state, or what was noted of them earlier. *)
  type expansion = Found of steps | Noted of noted

  (** The callbacks of an exploration. *)
  type visitor = {
    found : t -> int -> int array -> unit;
    opened : (t -> int -> int array -> edge array -> unit) option;
    earlier : t -> int -> unit;
    enough : unit -> bool;
    matters : Rat.t -> bool;
    dull : int array -> bool;
  }

  val blind : visitor
  (** The visitor that does nothing. *)

  (** The receiver of the results of one state. *)
  type told = { asks : int -> bool; tell : int -> noted -> unit }

  (** An answer of another process ({!Answers}): where its words begin. *)
  type answer = { words : Answers.words; at : int }

  (** The way in which transitions of states are computed. *)
  type expander = {
    ready : int -> answer option;
    expand : int -> int array -> (expansion, L.fault) result;
    expanded : unit -> told option;
    finish : unit -> unit;
  }

  (** {1 States} *)

  val out_of_bounds : t -> Limits.t -> int -> L.fault Statuses.reason option
  (** [out_of_bounds g limits i] is the bound on states that keeps state [i] from being expanded. *)

  val mark : t -> int -> L.fault Statuses.status -> unit
  (** [mark g i status] gives state [i] a status. *)

  val leave_out : t -> int -> L.fault Statuses.reason -> unit
  (** [leave_out g i reason]: state [i] will not be expanded. *)

  val add : t -> Limits.t -> int -> Distances.label -> (unit -> int array) -> unit
  (** [add g limits i label tuple] makes the state [i], the next one, whose path from the initial state has this
      label. It is queued, unless its tuple has too long a number. *)

  val after : t -> int -> int -> Distances.label
  (** [after g i label] is the label of the path to state [i] with a transition more, of the label
      [label]. *)

  (** {1 Edges} *)

  val is_plain : t -> deeper:int -> arrival:int -> int -> int -> bool
  (** [is_plain g ~deeper ~arrival label target] is true if an edge clearly changes nothing for a state that is
      known. [deeper] is the depth to which it leads, and [arrival] the number of the arrival at its source. *)

  val relax : t -> Limits.t -> visitor -> int -> int -> int -> unit
  (** [relax g limits visitor i label target] passes on what an edge from state [i] changes: depths, arrivals, and
      states that come within the bounds. *)

  val relax_unless_plain : t -> Limits.t -> visitor -> int -> int -> int -> bool
  (** As {!relax}, unless the edge is plain ({!is_plain}); whether it was not. *)

  val remember_at_once : t -> int -> int -> unit
  (** [remember_at_once g i count] keeps edges without duration for a later search for cycles, if no edges are kept
      elsewhere. They are those of state [i], the first [count] in [labels] and [targets]. *)
end
