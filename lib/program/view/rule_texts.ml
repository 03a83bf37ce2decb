let heading = "### "

let is_prefix p s = String.length s >= String.length p && String.equal (String.sub s 0 (String.length p)) p

(* An entry ends where the next one begins, or a chapter. *)
let rec entry taken = function
  | line :: rest when not (is_prefix "#" line) -> entry (line :: taken) rest
  | _ -> List.rev taken

let bookkeeping line = List.exists (fun p -> is_prefix p line) [ "- Code:"; "- Test:"; "- Model:" ]

let find name =
  let rec from = function
    | [] -> None
    | line :: rest when String.equal line (heading ^ name) ->
      let text = List.filter (fun l -> not (bookkeeping l)) (entry [] rest) in
      Some (String.trim (String.concat "\n" text))
    | _ :: rest -> from rest
  in
  from (String.split_on_char '\n' Rulebook_text.text)
