(** Transitions as bytes, to another process or to a later one: numbers of labels and of what is in the slots by
    {!Dictionary}, one for each family. *)

open Scc_codec
open Scc_graph_search

module Make (E : Lts.Exchange) : sig
  type t

  val make : E.context -> t
  val knows_label : t -> int -> bool
  val put_label : t -> Buffer.t -> int -> unit
  val read_label : t -> Packed.source -> int

  val put_changes : t -> Buffer.t -> Tuples.changes -> unit
  val read_changes : t -> Packed.source -> Tuples.changes

  val put_tuple : t -> Buffer.t -> int array -> unit
  (** Tuples are put and read in the same order, as each is told by what is different from the one before. They are
      not written to afterwards; so are steps. *)

  val read_tuple : t -> Packed.source -> int array

  val put_step : t -> Buffer.t -> Lts.step -> unit
  val read_step : t -> Packed.source -> Lts.step

  val put_recent : t -> Buffer.t -> Lts.step -> unit
  (** A step in short, if it came up lately; in order as well. The bytes depend on the numbers of this process. *)

  val read_recent : t -> Packed.source -> Lts.step
end
(** Readers raise {!Packed.Malformed} and [Failure]. *)
