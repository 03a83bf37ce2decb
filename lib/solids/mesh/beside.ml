type reader = string -> (string, string) result

let none _ = Error "no files are read beside it"

let stays name =
  let parts = String.split_on_char '/' name in
  let odd c = c = ':' || c = '\\' || c < ' ' in
  let fine part = part <> "" && part <> ".." && not (String.exists odd part) in
  List.for_all fine parts

let path ~path name =
  if not (stays name) then Error "only files beside it are read, by a name without `..`, drive or address"
  else
    let folder = Filename.dirname path in
    let parts = List.filter (fun part -> part <> ".") (String.split_on_char '/' name) in
    let name = String.concat "/" parts in
    Ok (if String.equal folder Filename.current_dir_name then name else Filename.concat folder name)

let find read ~path:beside name = Result.bind (path ~path:beside name) read

let address read ~path:beside name =
  let one name =
    Result.bind (path ~path:beside name) (fun path -> Result.map (fun text -> (path, text)) (read path))
  in
  match (one name, Scc_base.Percent.decoded_strictly name) with
  | Error _, Some decoded when not (String.equal decoded name) -> one decoded
  | found, _ -> found
