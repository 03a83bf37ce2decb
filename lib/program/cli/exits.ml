open Scc_verdicts

let man ?(told = []) ?(never = []) () =
  let is code (other, _) = Exit_code.equal code other in
  let info code =
    let doc = match List.find_opt (is code) told with Some (_, doc) -> doc | None -> Exit_code.meaning code in
    Cmdliner.Cmd.Exit.info (Exit_code.to_int code) ~doc
  in
  List.map info (List.filter (fun code -> not (List.exists (Exit_code.equal code) never)) Exit_code.all)
