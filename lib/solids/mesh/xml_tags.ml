open Scc_data
open Text

type attribute = { key : word; value : int * int }
type tag = { name : word; attributes : attribute list; closed : bool }

let is_space c = c = ' ' || c = '\t' || c = '\n' || c = '\r'
let is_name c = not (is_space c || c = '>' || c = '/' || c = '=' || c = '<')

let rec skip text test i = if i < String.length text && test text.[i] then skip text test (i + 1) else i

let find text part from =
  let n = String.length part in
  let rec go i =
    if i + n > String.length text then None
    else if String.equal (String.sub text i n) part then Some i
    else go (i + 1)
  in
  go from

(* The attributes from [i] to the end of the tag, and the position after it. *)
let rec attributes ~path name text acc i =
  let i = skip text is_space i in
  if i >= String.length text then error ~path name "the tag %s does not end" (quote name.text)
  else if text.[i] = '>' then Ok (List.rev acc, i + 1)
  else if text.[i] = '/' && i + 1 < String.length text && text.[i + 1] = '>' then Ok (List.rev acc, i + 2)
  else if not (is_name text.[i]) then error_at ~path i "%C does not stand in a tag" text.[i]
  else
    let stop = skip text is_name i in
    let equals = skip text is_space stop in
    let quote_at = skip text is_space (equals + 1) in
    let quoted =
      equals < String.length text && text.[equals] = '=' && quote_at < String.length text
      && (text.[quote_at] = '"' || text.[quote_at] = '\'')
    in
    match if quoted then String.index_from_opt text (quote_at + 1) text.[quote_at] else None with
    | Some close ->
      let key = { text = String.sub text i (stop - i); start = i } in
      attributes ~path name text ({ key; value = (quote_at + 1, close) } :: acc) (close + 1)
    | None -> error_at ~path i "expected an attribute with a quoted value"

let characters = "#text"

(* Tags in order, closing ones with a leading slash in their names; comments and declarations left out. *)
let tags ~path text =
  let with_text acc i stop =
    let start = skip text is_space i in
    if start >= stop then acc
    else { name = { text = characters; start }; attributes = []; closed = true } :: acc
  in
  let rec go acc from =
    match String.index_from_opt text from '<' with
    | None -> Ok (List.rev (with_text acc from (String.length text)))
    | Some i -> (
        let acc = with_text acc from i in
        let after what close =
          match find text close (i + 1) with
          | Some j -> go acc (j + String.length close)
          | None -> error_at ~path i "%s does not end" what
        in
        let starts part =
          i + String.length part <= String.length text
          && String.equal (String.sub text i (String.length part)) part
        in
        if starts "<!--" then after "a comment" "-->"
        else if starts "<![CDATA[" then
          match find text "]]>" (i + 1) with
          | Some stop -> go (with_text acc (i + 9) stop) (stop + 3)
          | None -> error_at ~path i "a CDATA section does not end"
        else if starts "<!" then
          (match (String.index_from_opt text i '>', String.index_from_opt text i '[') with
           | Some stop, Some bracket when bracket < stop ->
             error_at ~path i "a document type with declarations of its own is not read: remove them"
           | _ -> after "a declaration" ">")
        else if starts "<?" then after "an instruction" "?>"
        else
          let start = if starts "</" then i + 2 else i + 1 in
          let stop = skip text is_name start in
          let name = { text = String.sub text (i + 1) (stop - i - 1); start = i + 1 } in
          match attributes ~path name text [] stop with
          | Ok (attributes, next) ->
            let closed = text.[next - 2] = '/' in
            go ({ name; attributes; closed } :: acc) next
          | Error _ as e -> e)
  in
  go [] 0

(* What a reference stands for, by what is between `&` and `;`: a character by its number, or an entity that XML
   itself defines. *)
let meaning name =
  let number digits =
    match int_of_string_opt digits with
    | Some n when n > 0 && Uchar.is_valid n ->
      let b = Buffer.create 4 in
      Buffer.add_utf_8_uchar b (Uchar.of_int n);
      Some (Buffer.contents b)
    | Some _ | None -> None
  in
  let after n = String.sub name n (String.length name - n) in
  let begins s = String.length name > String.length s && String.equal (String.sub name 0 (String.length s)) s in
  let all test digits = String.length digits <= 8 && String.for_all test digits in
  let decimal = function '0' .. '9' -> true | _ -> false in
  let hexadecimal = function '0' .. '9' | 'a' .. 'f' | 'A' .. 'F' -> true | _ -> false in
  match name with
  | "lt" -> Some "<"
  | "gt" -> Some ">"
  | "amp" -> Some "&"
  | "quot" -> Some "\""
  | "apos" -> Some "'"
  | _ when begins "#x" && all hexadecimal (after 2) -> number ("0x" ^ after 2)
  | _ when begins "#" && all decimal (after 1) -> number (after 1)
  | _ -> None

(* From one place of the file to another, with what references stand for; and the place of each byte. *)
let decoded ~path text start stop =
  let b = Buffer.create (stop - start) and places = Growable.create () in
  let add at s =
    String.iter
      (fun c ->
         Buffer.add_char b c;
         Growable.push places at)
      s
  in
  let rec go i =
    if i >= stop then Ok (Buffer.contents b, Growable.get places)
    else if text.[i] <> '&' then begin
      add i (String.make 1 text.[i]);
      go (i + 1)
    end
    else
      let close = match String.index_from_opt text i ';' with Some j when j < stop -> j | _ -> i in
      let name = String.sub text (i + 1) (max 0 (close - i - 1)) in
      match meaning name with
      | Some s ->
        add i s;
        go (close + 1)
      | None ->
        let word = String.sub text i (max 1 (close - i + 1)) in
        error ~path { text = word; start = i }
          "%s is no reference that XML knows: &amp; &lt; &gt; &quot; &apos;, or a character's number as in &#45;"
          (quote word)
  in
  go start

let value ~path text attribute =
  let start, stop = attribute.value in
  Result.map fst (decoded ~path text start stop)

let blank c = is_space c || c = ',' || c = '\x0c'

let split text start stop =
  let rec skip acc i =
    if i >= stop then List.rev acc else if blank text.[i] then skip acc (i + 1) else word acc i i
  and word acc start i =
    if i >= stop || blank text.[i] then skip ({ text = String.sub text start (i - start); start } :: acc) i
    else word acc start (i + 1)
  in
  skip [] start

let words ~path text attribute =
  let start, stop = attribute.value in
  match String.index_from_opt text start '&' with
  | Some i when i < stop ->
    let* value, place = decoded ~path text start stop in
    Ok (List.map (fun w -> { w with start = place w.start }) (split value 0 (String.length value)))
  | Some _ | None -> Ok (split text start stop)

let well_formed ~path text tags =
  let names = List.sort compare in
  let rec twice = function
    | (a : word) :: ((b : word) :: _ as rest) -> if String.equal a.text b.text then Some b else twice rest
    | [ _ ] | [] -> None
  in
  let attribute a =
    let start, stop = a.value in
    let* _ = value ~path text a in
    match String.index_from_opt text start '<' with
    | Some i when i < stop -> error_at ~path i "a `<` stands in the value of an attribute: write &lt;"
    | Some _ | None -> Ok ()
  in
  let tag t =
    let* _ = Result.all attribute t.attributes in
    match twice (names (List.map (fun a -> a.key) t.attributes)) with
    | Some key -> error ~path key "the attribute %s is there twice" (quote key.text)
    | None -> Ok ()
  in
  Result.map ignore (Result.all tag tags)
