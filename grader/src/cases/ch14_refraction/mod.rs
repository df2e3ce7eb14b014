//! Chapter 14: `refract`, `fresnel`.

raybook_workbook::ch14_refraction!(graded);
