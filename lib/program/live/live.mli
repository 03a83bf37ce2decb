(** Documents that go on while somebody looks at them: what is not told of a page yet is asked for. *)

open Scc_oracle
open Scc_view

val methods : Document.t -> (string * Oracle.work) list
(** The methods of the service ({!Oracle}) over one document. All of them take [have], how many rows of each table
    the page knows, and answer [more]: the rows after these, and anew the states that were looked at.

    - [document.expand] ([state]): what is possible in a state, and where it leads.
    - [document.walk] ([state], [choices]): the same along a way; answers those of the choices that were possible.
    - [document.onwards] ([state], [most]): the first of what is possible, again and again, until nothing is, or a
      state comes again; answers the choices. *)
