let names = List.map fst Library_text.files
let find name = List.assoc_opt name Library_text.files
