(** Methods of the service: what the schema says of them, and what they compute. *)

open Scc_json

(** A method that needs a ['store]. *)
type 'store t = {
  name : string;
  params : Json_schema.member list;
  result : Json_schema.t;
  work : 'store -> Read.params -> Reply.t;
}

val make :
  string -> Json_schema.member list -> ('a, _) Json_format.t -> ('store -> Read.params -> 'a) -> 'store t
(** [make name params result work] refuses other params than [params], and answers by [work] in the format
    [result]. *)

(** {1 The param limits} *)

val plain_limits : Read.params Read.member
(** The param of methods that do not explore. *)

val limits : Json_schema.member
(** The member {!plain_limits} in the list of params of a method. *)

val all_limits : Read.params Read.member
(** The param of methods that explore. *)

val seconds : Scc_exact.Rat.t Read.member
(** The greatest time for the request. *)

val states : int Read.member
(** The greatest number of states. *)

val depth : int Read.member
(** The greatest number of transitions on a path. *)

val time : Scc_exact.Rat.t Read.member
(** The greatest model time. *)
