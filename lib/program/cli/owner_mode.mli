(** [scc successors --owner K/N]: one of several processes that explore a model together. *)

open Scc_base
open Scc_verdicts

type t = { place : Scc_owners.Owner.place; address : string }
(** Which owner it is, and the address at which others call it. *)

val term : t option Cmdliner.Term.t
(** The options [--owner] and [--listen]. *)

val listen : string -> (Unix.file_descr, Diag.t list) result
(** [listen address] is a socket at a free port of an address of this machine. *)

val port : Unix.file_descr -> int
(** Its port. *)

val run :
  Console.t ->
  t ->
  Scc_successors.Filter.t ->
  listener:Unix.file_descr ->
  identity:string ->
  (Exit_code.t, Diag.t list) result
(** [run console t filter ~listener ~identity] is the work of the owner ({!Scc_owners.Owner.run}), after the
    header of its output. [identity] is what is explored. *)
