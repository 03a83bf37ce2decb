open Scc_base
open Scc_property
open Scc_loading
open Cmdliner

let option ~doc = Arg.(value & opt_all string [] & info [ "check" ] ~docv:"NAME" ~doc)

let named (l : Loaded.t) name =
  let base (c : Property.check) = List.hd (String.split_on_char '[' c.name) in
  let is_meant (c : Property.check) = String.equal name c.name || String.equal name (base c) in
  match List.filter is_meant l.checks with
  | [] when Scc_elaborate.Repeated.has_check l.families name -> Ok []
  | [] -> Error [ Input.no_check Code.unknown_name Span.command_line name l.checks ]
  | found -> Ok found

let of_names l names = Result.map List.concat (Result.all (named l) names)

let only (l : Loaded.t) = function
  | [] -> Ok l
  | names ->
    let* chosen = of_names l names in
    let is_chosen (c : Property.check) =
      List.exists (fun (d : Property.check) -> String.equal c.name d.name) chosen
    in
    Ok { l with checks = List.filter is_chosen l.checks; premises = List.filter is_chosen l.premises }
