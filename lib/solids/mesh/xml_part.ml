open Scc_base

exception Refused of Diag.t

type t = { path : string; part : string; input : Xmlm.input; mutable depth : int }

let refuse ~path ~part line what =
  match Text.error_at ~path 0 "%s, line %d: %s" part line what with
  | Error d -> raise (Refused d)
  | Ok _ -> Bug.fail __POS__ "an error is none"

let fail t fmt = Printf.ksprintf (fun what -> refuse ~path:t.path ~part:t.part (fst (Xmlm.pos t.input)) what) fmt

let place t = Printf.sprintf "%s, line %d" t.part (fst (Xmlm.pos t.input))

let told (e : Xmlm.error) =
  match e with
  | `Unknown_entity_ref name -> Printf.sprintf "%s is no entity of XML itself" (Text.quote name)
  | `Unexpected_eoi -> "the text ends before the document does"
  | `Unknown_ns_prefix p -> Printf.sprintf "the prefix %s is bound to no namespace" (Text.quote p)
  | `Illegal_char_ref c -> Printf.sprintf "%s is no character" (Text.quote c)
  | `Illegal_char_seq s -> Printf.sprintf "%s does not fit here in XML" (Text.quote s)
  | `Expected_char_seqs (_, found) -> Printf.sprintf "%s does not fit here in XML" (Text.quote found)
  | `Expected_root_element | `Malformed_char_stream | `Max_buffer_size | `Unknown_encoding _ ->
    "this is not well-formed XML"

let max_depth = 100

(* By XML, no attribute is there twice; Xmlm does not see to it. *)
let rec twice : Xmlm.attribute list -> string option = function
  | (a, _) :: ((b, _) :: _ as rest) -> if a = b then Some (snd a) else twice rest
  | [ _ ] | [] -> None

let next t =
  match Xmlm.input t.input with
  | `El_start (_, attributes) as signal ->
    (match twice (List.sort (fun ((a : Xmlm.name), _) (b, _) -> compare a b) attributes) with
     | Some name -> fail t "the attribute %s is there twice" (Text.quote name)
     | None -> ());
    t.depth <- t.depth + 1;
    if t.depth > max_depth then fail t "elements are nested more than %d deep" max_depth;
    signal
  | `El_end as signal ->
    t.depth <- t.depth - 1;
    signal
  | (`Data _ | `Dtd _) as signal -> signal
  | exception Xmlm.Error ((line, _), e) -> refuse ~path:t.path ~part:t.part line (told e)

let rec children t f =
  match next t with
  | `El_start tag ->
    f tag;
    children t f
  | `El_end -> ()
  | `Data text when String.trim text <> "" -> fail t "a text, %s, stands where only elements do" (Text.quote text)
  | `Data _ | `Dtd _ -> children t f

let skip t =
  let above = t.depth - 1 in
  while t.depth > above do
    ignore (next t)
  done

let attribute ((_, attributes) : Xmlm.tag) name = Option.map String.trim (List.assoc_opt ("", name) attributes)

let needed t tag name =
  match attribute tag name with
  | Some value -> value
  | None -> fail t "`%s` of `%s` is missing" name (snd (fst tag))

let encrypted = "%3McF"

let read ~path ~part text f =
  if String.starts_with ~prefix:encrypted text then refuse ~path ~part 1 "the part is encrypted";
  let input = Xmlm.make_input ~enc:(Some `UTF_8) ~strip:true (`String (Source.after_mark text, text)) in
  let t = { path; part; input; depth = 0 } in
  match next t with
  | `Dtd (Some _) -> fail t "a document type is not read"
  | `Dtd None -> (
      match next t with
      | `El_start tag -> (
          let result = f t tag in
          match Xmlm.eoi input with
          | true -> result
          | false -> fail t "nothing follows the first element of a document"
          | exception Xmlm.Error ((line, _), e) -> refuse ~path ~part line (told e))
      | `El_end | `Data _ | `Dtd _ -> fail t "a document begins with an element")
  | `El_start _ | `El_end | `Data _ -> fail t "a document begins with its type, or none"
