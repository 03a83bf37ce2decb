let names = List.map fst Library_text.files
let declared text =
  let of_line line =
    match String.split_on_char ' ' line with
    | ("shape" | "compound") :: head :: _ -> Some ("template", List.hd (String.split_on_char '(' head))
    | "behaviour" :: head :: _ -> Some ("behaviour", List.hd (String.split_on_char '(' head))
    | _ -> None
  in
  List.filter_map of_line (String.split_on_char '\n' text)

let declaring kind name =
  let is (k, n) = String.equal k kind && String.equal n name in
  Option.map fst (List.find_opt (fun (_, text) -> List.exists is (declared text)) Library_text.files)

let find name = List.assoc_opt name Library_text.files
