open Scc_equivalence
open Cmdliner

type pattern = { source : string; pattern : Label.pattern }

let matches p text = Option.is_some (Label.matches p.pattern text)

(* A kind stands for all labels of it. *)
let of_string source =
  let is_kind = not (String.exists (function '(' | '*' -> true | _ -> false) source) in
  { source; pattern = Label.pattern (if is_kind then source ^ "(*)" else source) }

let pattern =
  let parse s =
    if String.equal s "" then Error (`Msg "an empty pattern fits no label") else Ok (of_string s)
  in
  Arg.conv ~docv:"PATTERN" (parse, fun ppf p -> Format.pp_print_string ppf p.source)

let patterns ?(also = "") () =
  let doc =
    "Makes the transitions invisible whose labels match $(docv): a kind ($(b,time), $(b,bounce), $(b,bind), \
     $(b,weak), $(b,strong)), or the text of a label, in which $(b,*) stands for any characters: $(b,'bind(glc, \
     *\\)'). Repeatable."
    ^ also
  in
  Arg.(value & opt_all pattern [] & info [ "hide" ] ~docv:"PATTERN" ~doc)
