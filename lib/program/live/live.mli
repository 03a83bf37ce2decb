(** Documents that grow while they are viewed: the page requests the parts that it does not have. *)

open Scc_oracle
open Scc_view

val methods : Document.t -> (string * Oracle.work) list
(** The methods of the service ({!Oracle}) over one document. Each takes [have], the number of rows that the
    page has of each table. Each answers [more]: the rows after these, and again the states that were visited.

    - [document.expand] ([state]): the transitions of a state and their targets.
    - [document.walk] ([state], [choices]): likewise along a path; answers the choices that were possible.
    - [document.onwards] ([state], [most]): takes the first transition again and again; answers the choices. It
      ends if there is none, if a state recurs, or after [most] transitions. *)
