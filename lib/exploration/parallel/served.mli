(** The work of a worker for the process that has the graph ({!Crew}), and the protocol between the two.

    A request is a number of states. Each state is 0 and its tuple, or a place. A state that came up in an answer
    of this worker is 1 + the place of that answer, and the distance from there to the step ({!Answered}). A
    reply is a heading and an answer for each state. An answer is one of these:
    - 0, if the process that has the graph must find the transitions itself;
    - 1, and all transitions;
    - 2, some transitions that may be enough ({!Scc_graph_search.Lts.S.reduced}), and all of them. *)

open Scc_codec
open Scc_graph_search

module Make (L : Lts.S) (E : Lts.Exchange with type context = L.context) : sig
  module Wire : module type of Wire.Make (E)

  type state = Tuple of int array | Place of { answer : int; step : int }

  (** The seconds that the worker has waited for the request and worked at it, and the words of memory that it
      takes. *)
  type heading = { waited : float; worked : float; words : int }

  type answer = Look | Steps of { some : Lts.step list option; all : Lts.step list }

  val kept : some:Lts.step list option -> all:Lts.step list -> Lts.step list
  (** [kept ~some ~all] is the steps of an answer in the order in which {!Answered.keep} has them: [some], then
      [all]. *)

  val put_state : Wire.t -> Buffer.t -> state -> unit
  (** Appends one state of a request. *)

  val read_heading : Packed.source -> heading
  (** Reads the heading of a reply. Raises {!Scc_codec.Packed.Malformed}. *)

  val read_answer : Wire.t -> Packed.source -> answer
  (** Reads the next answer of a reply. The answers of all replies of a worker must be read in their order. Raises
      {!Scc_codec.Packed.Malformed} and [Failure]. *)

  val serve : L.context -> Channel.t -> unit
  (** [serve context channel] is the work of a worker. It answers requests until {!Channel.Closed} is raised. *)
end
