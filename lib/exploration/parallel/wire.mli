(** Transitions as bytes, for another process or for a later run. Numbers of labels and of components are sent by
    {!Dictionary}, one for the labels and one for each family of slots. Readers raise [Packed.Malformed] and
    [Failure]. *)

open Scc_codec
open Scc_graph_search

module Make (E : Lts.Exchange) : sig
  type t

  val make : E.context -> t
  (** The state of one direction of a connection. Both sides begin with a new one. *)

  val knows_label : t -> int -> bool
  (** [knows_label w label] is true if the label has been put or read before. *)

  val put_label : t -> Buffer.t -> int -> unit
  (** Appends a label, by its number in this process. *)

  val read_label : t -> Packed.source -> int
  (** Reads a label and returns its number in this process. *)

  val put_changes : t -> Buffer.t -> Tuples.changes -> unit
  (** Appends changes of slots. *)

  val read_changes : t -> Packed.source -> Tuples.changes
  (** Reads changes of slots, with the numbers of this process. *)

  val put_step : t -> Buffer.t -> Lts.step -> unit
  (** Appends a step: its label and its changes. *)

  val read_step : t -> Packed.source -> Lts.step
  (** Reads a step of {!put_step}. *)
end
