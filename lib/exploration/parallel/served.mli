(** What another process does for the one that has the graph ({!Crew}), and how the two talk.

    A request is a number of states. Each is 0 and its tuple, or, of one that came up in an answer of the other
    process, 1 + the place of that answer and how far it is from there to the step ({!Answered}). A reply is a
    heading and, of each of the states, 0 where its transitions have to be looked at by the process that asked;
    1 and all of them; or 2, those that may do ({!Lts.S.reduced}), and all of them. *)

open Scc_codec
open Scc_graph_search

module Make (L : Lts.S) (E : Lts.Exchange with type context = L.context) : sig
  module Wire : module type of Wire.Make (E)

  type state = Tuple of int array | Place of { answer : int; step : int }

  (** Seconds that the other process has waited for the request, and worked at it; and the words of memory
      that it takes. *)
  type heading = { waited : float; worked : float; words : int }

  type answer = Look | Steps of { some : Lts.step list option; all : Lts.step list }

  val kept : some:Lts.step list option -> all:Lts.step list -> Lts.step list
  (** The steps of an answer as {!Answered.keep} has them. *)

  val put_state : Wire.t -> Buffer.t -> state -> unit
  val read_heading : Packed.source -> heading

  val read_answer : Wire.t -> Packed.source -> answer
  (** Answers are read one by one, in their order. *)

  val serve : L.context -> Channel.t -> unit
  (** In another process: answers requests until the channel is closed. *)
end
