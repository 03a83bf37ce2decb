(* Tests run in test/meta of the build folder. *)
let from_root path = Filename.concat "../.." path
let exists path = Sys.file_exists (from_root path)

let read path =
  match open_in_bin (from_root path) with
  | exception Sys_error _ -> ""
  | ic ->
    Fun.protect
      ~finally:(fun () -> close_in ic)
      (fun () -> really_input_string ic (in_channel_length ic))

(* The build tree also contains folders of the compilers ([.objs]) and of test runners ([_build]). Their files come
   and go while tests run. *)
let is_source name = name.[0] <> '.' && name <> "_build"

let rec files path =
  match Sys.readdir (from_root path) with
  | exception Sys_error _ -> []
  | names ->
    Array.sort String.compare names;
    Array.to_list names |> List.filter is_source
    |> List.concat_map (fun name ->
        let path = path ^ "/" ^ name in
        match Sys.is_directory (from_root path) with
        | true -> files path
        | false -> [ path ]
        | exception Sys_error _ -> [])

let matches_at text part i =
  let n = String.length part in
  let rec from j = j = n || (text.[i + j] = part.[j] && from (j + 1)) in
  i + n <= String.length text && from 0

(* Every place where [part] occurs. *)
let places text part =
  let rec from i found =
    match if part = "" then None else String.index_from_opt text i part.[0] with
    | None -> List.rev found
    | Some i -> from (i + 1) (if matches_at text part i then i :: found else found)
  in
  from 0 []

let contains text part = places text part <> []

let starts_with part text = String.length part <= String.length text && matches_at text part 0

let quoted_after prefix text =
  let mark = "\"" ^ prefix in
  places text mark
  |> List.filter_map (fun i ->
      match String.index_from_opt text (i + 1) '"' with
      | Some stop -> Some (String.sub text (i + 1) (stop - i - 1))
      | None -> None)

let is_word = function
  | 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '.' | '-' -> true
  | _ -> false

let is_letter = function 'a' .. 'z' | 'A' .. 'Z' | '_' -> true | _ -> false

let rec strip word =
  let n = String.length word in
  if n > 0 && (word.[n - 1] = '.' || word.[n - 1] = '-') then strip (String.sub word 0 (n - 1)) else word

let words_after prefix text =
  let rec stop i = if i < String.length text && is_word text.[i] then stop (i + 1) else i in
  places text prefix
  |> List.filter (fun i -> i = 0 || not (is_letter text.[i - 1]))
  |> List.map (fun i ->
      let first = i + String.length prefix in
      strip (String.sub text first (stop first - first)))
