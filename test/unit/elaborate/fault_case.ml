(* A text with a fault: the code that is to be reported, and where. *)

open Scc_base
open Models

type case = {
  name : string;
  code : string;
  at : string;  (** the text that the span covers; [""] for no place *)
  says : string;  (** a piece of the message or the hint *)
  text : string;
}

let case name code at ?(says = "") text = { name; code; at; says; text }

let contains whole piece =
  let n = String.length whole and k = String.length piece in
  let rec from i = i + k <= n && (String.equal (String.sub whole i k) piece || from (i + 1)) in
  from 0

let fits c (d : Diag.t) =
  let at = if Span.is_none d.span then "" else underlined c.text d.span in
  let words = d.message ^ Option.value ~default:"" d.hint in
  String.equal d.code c.code && String.equal at c.at && contains words c.says

let check ?overrides ?read_file c () =
  let found =
    match elaborate ?overrides ?read_file c.text with
    | Ok t -> t.warnings
    | Error diagnostics -> diagnostics
  in
  if not (List.exists (fits c) found) then
    Alcotest.failf "expected %s at `%s` (%s), found:\n%s" c.code c.at c.says
      (String.concat "" (List.map (show c.text) found))

let cases list = List.map (fun c -> Alcotest.test_case (c.code ^ " " ^ c.name) `Quick (check c)) list
